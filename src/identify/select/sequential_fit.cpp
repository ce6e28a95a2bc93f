#include "identify/select/sequential_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "identify/fit/windowed_fit.hpp"
#include "identify/noise/force_noise.hpp"
#include "identify/select/close_mode_search.hpp"
#include "identify/select/frequency_scatter.hpp"
#include "identify/select/mode_acceptance.hpp"
#include "identify/select/residual_mode_search.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/truncation_ripples.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t kMinFitLines = 16;  // lines

class SequentialFit {
 public:
  SequentialFit(const FrfDataset& set, const SequentialFitOptions& options)
      : set_(set), options_(options), all_(set, options.windows) {}

  std::vector<FittedMode> run() {
    context_.peak_poles = poles_near(set_, options_.start_Hz);
    context_.peak_poles.insert(context_.peak_poles.end(), options_.start.begin(), options_.start.end());
    const bool given = !context_.peak_poles.empty();
    if (!given) context_.peak_poles = candidate_poles(set_, all_.line_noise());
    if (given) {
      start_from(context_.peak_poles);
    } else {
      start_without_ripples();
      all_.widen();
      search_modes();
    }
    if (!options_.start.empty()) keep_accepted();
    return modes();
  }

 private:
  void search_modes() {
    search_rounds(options_.hidden ? std::optional(ResidualModeSearch::SearchPass::all) : std::nullopt);
    // A crowd of hidden ones may drive a mode that shows from its place: then they were none, but perhaps one broad
    // one.
    const std::vector<Pole> lost = lost_modes(all_.poles());
    if (!hidden_.has_tried_any() || lost.empty()) return;
    const std::vector<Pole> found = all_.poles();
    for (const auto hidden :
         {std::optional(ResidualModeSearch::SearchPass::alone), std::optional<ResidualModeSearch::SearchPass>()}) {
      start_from(established_);
      search_rounds(hidden);
      if (lost_modes(all_.poles()).size() < lost.size()) return;
    }
    start_from(found);
    keep_accepted();
  }

  // Where a decay is cut off it leaves ripples on its resonance's flanks that look like peaks: those begin with the
  // others only if they are still there once it has been fitted.
  void start_without_ripples() {
    const std::vector<char> doubtful = find_truncation_ripples(set_, context_.peak_poles);
    std::vector<Pole> first, later;
    for (std::size_t p = 0; p < doubtful.size(); ++p) (doubtful[p] ? later : first).push_back(context_.peak_poles[p]);
    start_from(first);
    if (later.empty()) return;
    const auto residual = all_.residual();
    std::erase_if(later, [&](const Pole& pole) { return !remains_in_residual(set_, pole, residual); });
    context_.peak_poles = std::move(first);
    context_.peak_poles.insert(context_.peak_poles.end(), later.begin(), later.end());
    std::vector<Pole> poles = all_.poles();
    poles.insert(poles.end(), later.begin(), later.end());
    if (use(std::move(poles))) all_.sweep();
  }

  void start_from(std::vector<Pole> poles) {
    context_.search_finished = false;
    all_.replace(std::move(poles));
    all_.sweep();
  }

  // The modes that were credible before hidden ones were looked for, and have nothing in their place now.
  std::vector<Pole> lost_modes(const std::vector<Pole>& now) const {
    std::vector<Pole> lost;
    std::copy_if(established_.begin(), established_.end(), std::back_inserter(lost), [&](const Pole& clear) {
      return std::none_of(now.begin(), now.end(), [&](const Pole& pole) {
        return std::abs(pole.freq_Hz - clear.freq_Hz) < all_.width_Hz(clear);
      });
    });
    return lost;
  }

  void search_rounds(std::optional<ResidualModeSearch::SearchPass> hidden) {
    for (int round = 0; round < options_.rounds; ++round) {
      while (merge_scattered_poles()) all_.sweep();
      const bool dropped = drop_insignificant();
      if (!hidden_.has_tried_any()) established_ = all_.poles();
      // Windows are split when what was dropped is out of them, and hidden modes looked for when no pair is left to be.
      const bool changed = dropped || use(split_.next(all_, context_)) || (hidden && add_residual_modes(*hidden));
      if (!changed) break;
      all_.sweep();
    }
    while (merge_scattered_poles()) all_.sweep();
    keep_accepted();
  }

  void keep_accepted() {
    context_.search_finished = true;
    while (drop_insignificant()) all_.sweep();
  }

  bool drop_insignificant() {
    std::vector<Pole> kept;
    for (const FitGroup& group : all_.groups()) {
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
        const Pole& pole = group.fit.poles[m];
        const bool twice =
            std::any_of(kept.begin(), kept.end(), [&](const Pole& k) { return poles_coincide(all_, k, pole); });
        if (!twice && accept_mode(all_, group, m, context_)) kept.push_back(pole);
      }
    }
    return use(std::move(kept));
  }

  // Poles of one mode that moves from point to point.
  bool merge_scattered_poles() {
    std::vector<Pole> kept;
    for (const FitGroup& group : all_.groups()) {
      if (const auto one = merge_if_scattered(all_, group)) {
        kept.push_back(*one);
      } else {
        kept.insert(kept.end(), group.fit.poles.begin(), group.fit.poles.end());
      }
    }
    return use(std::move(kept));
  }

  // Replaces the poles when their number has changed.
  bool use(std::vector<Pole> poles) {
    if (poles.size() == all_.poles().size()) return false;
    all_.replace(std::move(poles));
    return true;
  }

  // Modes that the residual over the whole band shows, away from those known.
  bool add_residual_modes(ResidualModeSearch::SearchPass way) {
    std::vector<Pole> poles = all_.poles();
    const std::vector<Pole> more = hidden_.next(all_, way);
    poles.insert(poles.end(), more.begin(), more.end());
    return use(std::move(poles));
  }

  Mode mode_of(const LocalFit& fit, std::size_t m) const {
    const auto i = static_cast<Index>(m);
    const Pole& pole = fit.poles[m];
    Mode mode{.pole = pole,
              .freq_std_Hz = std::hypot(fit.freq_std_Hz(i), kRounding * pole.freq_Hz),
              .damping_std = std::hypot(fit.damping_std(i), kRoundingDamping * pole.damping_ratio)};
    for (std::size_t o = 0; o < set_.outputs.size(); ++o) {
      mode.residues.push_back({.point = set_.outputs[o].point,
                               .channel = set_.outputs[o].channel,
                               .value = fit.residues(static_cast<Index>(o), i),
                               .std = fit.residue_std(static_cast<Index>(o), i),
                               .relative_std = gain_deviation(set_, set_.outputs[o].point, mode.pole.freq_Hz)});
    }
    return mode;
  }

  static void move(FittedMode& found, const ScatteredMode& moving) {
    found.noise = moving.noise;
    Mode& mode = found.mode;
    mode.pole = moving.pole;
    mode.freq_std_Hz = moving.freq_std_Hz;
    mode.damping_std = moving.damping_std;
    mode.freq_scatter_Hz = moving.freq_scatter_Hz;
    for (std::size_t o = 0; o < mode.residues.size(); ++o) {
      mode.residues[o].value = moving.residues[o];
      mode.residues[o].std = moving.residue_std[o];
      mode.residues[o].own_pole = moving.own_poles[o];
    }
  }

  std::vector<FittedMode> modes() const {
    std::vector<FittedMode> found;
    for (const FitGroup& group : all_.groups()) {
      const auto moving = scattered_modes(all_, group);
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
        found.push_back({.mode = mode_of(group.fit, m),
                         .peak_to_residual = peak_to_residual(all_, group, m),
                         .first = group.first,
                         .count = group.count,
                         .noise = group.fit.noise,
                         .unknowns_per_output = 2 * (group.fit.poles.size() + LocalFitOptions{}.residual_terms)});
        if (!moving.empty()) move(found.back(), moving[m]);
      }
    }
    if (options_.modes && *options_.modes < found.size()) {
      std::stable_sort(found.begin(), found.end(), [](const FittedMode& a, const FittedMode& b) {
        return a.peak_to_residual > b.peak_to_residual;
      });
      found.resize(*options_.modes);
    }
    // Poles fitted together may have passed each other.
    std::sort(found.begin(), found.end(),
              [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
    return found;
  }

  const FrfDataset& set_;
  const SequentialFitOptions& options_;
  WindowedFit all_;
  AcceptanceContext context_;
  CloseModeSearch split_;
  ResidualModeSearch hidden_;
  std::vector<Pole> established_;  // modes found before hidden ones were tried
};

}  // namespace

SequentialFitOptions sequential_fit_options(Effort effort) {
  if (effort == Effort::quick) return {.rounds = 3, .hidden = false, .windows = {.window_widths = 5, .change = 0.1}};
  return {};
}

std::vector<FittedMode> fit_sequentially(const FrfDataset& set, const SequentialFitOptions& options) {
  if (set.lines.count < kMinFitLines || set.outputs.empty()) return {};
  return SequentialFit(set, options).run();
}

}  // namespace percuss::identify
