#include "identify/select/sequential_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "identify/model/close_poles.hpp"
#include "identify/select/close_mode_search.hpp"
#include "identify/select/frequency_scatter.hpp"
#include "identify/select/mode_acceptance.hpp"
#include "identify/select/residual_mode_search.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/truncation_ripples.hpp"

namespace percuss::identify {
namespace {

constexpr std::size_t kMinFitLines = 16;
constexpr int kMaxRegroupings = 4;  // after the search
constexpr int kMaxSettlingSweeps = 10;

// The steps of the search, in the order of a round. The close-mode search starts when no insignificant mode is left to
// drop, and the residual-mode search when no close mode is found.
enum class Step { drop_insignificant, split_close, add_residual };
constexpr std::array kSteps{Step::drop_insignificant, Step::split_close, Step::add_residual};

// The effect of a step on the set of modes.
enum class Outcome { unchanged, changed };

class SequentialFit {
 public:
  SequentialFit(const FrfDataset& set, const SequentialFitOptions& options)
      : set_(set), options_(options), fit_(set, options.windows) {}

  std::vector<FittedMode> run() {
    context_.peak_poles = poles_near(set_, options_.start_Hz);
    context_.peak_poles.insert(context_.peak_poles.end(), options_.start.begin(), options_.start.end());
    if (!context_.peak_poles.empty()) {
      start_from(context_.peak_poles);
    } else {
      start_from_peaks();
      search();
    }
    if (options_.settle) settle();
    if (!options_.start.empty() && !options_.keep_all) drop_until_accepted();
    return fitted_modes(fit_);
  }

 private:
  void start_from(std::vector<Pole> poles) {
    context_.search_finished = false;
    fit_.replace(std::move(poles));
    fit_.sweep();
  }

  // A sweep fits each group while the other groups still have errors. These errors bias a group whose wide window
  // contains modes of other groups, so the sweeps are repeated until the poles stay.
  void settle() {
    for (int sweep = 0; sweep < kMaxSettlingSweeps; ++sweep) {
      const std::vector<Pole> before = fit_.poles();
      fit_.sweep();
      if (fit_.poles() == before) return;
    }
  }

  // A truncated decay leaves ripples beside its resonance that look like peaks. A doubtful peak joins the others only
  // if the residual still shows it once the resonance is fitted.
  void start_from_peaks() {
    const std::vector<Pole> peaks = candidate_poles(set_, fit_.line_noise());
    const std::vector<char> doubtful = find_truncation_ripples(set_, peaks);
    std::vector<Pole> clear, later;
    for (std::size_t p = 0; p < peaks.size(); ++p) (doubtful[p] ? later : clear).push_back(peaks[p]);
    context_.peak_poles = peaks;
    start_from(clear);
    if (!later.empty()) {
      const auto residual = fit_.residual();
      std::erase_if(later, [&](const Pole& pole) { return !remains_in_residual(set_, pole, residual); });
      context_.peak_poles = std::move(clear);
      context_.peak_poles.insert(context_.peak_poles.end(), later.begin(), later.end());
      if (add(later) == Outcome::changed) fit_.sweep();
    }
    fit_.widen();
  }

  // Spurious modes from the residual can displace a mode that a peak showed. The search is then repeated with one broad
  // residual mode, and after that with none.
  void search() {
    search_rounds(options_.search_residual ? ResidualSearch::all : ResidualSearch::none);
    const std::vector<Pole> displaced = displaced_modes();
    if (displaced.empty()) return;
    const std::vector<Pole> found = fit_.poles();
    for (const ResidualSearch which : {ResidualSearch::one_broad, ResidualSearch::none}) {
      start_from(peak_modes_);
      search_rounds(which);
      if (displaced_modes().size() < displaced.size()) return;
    }
    start_from(found);
    drop_until_accepted();
  }

  // Modes that the peaks showed and that have no pole within their width now.
  std::vector<Pole> displaced_modes() const {
    std::vector<Pole> displaced;
    if (!residual_search_.has_tried_any()) return displaced;
    const std::vector<Pole> now = fit_.poles();
    std::copy_if(peak_modes_.begin(), peak_modes_.end(), std::back_inserter(displaced), [&](const Pole& known) {
      return std::none_of(now.begin(), now.end(), [&](const Pole& pole) {
        return std::abs(pole.freq_Hz - known.freq_Hz) < fit_.width_Hz(known);
      });
    });
    return displaced;
  }

  void search_rounds(ResidualSearch which) {
    for (int round = 0; round < options_.max_rounds; ++round) {
      merge_scattered();
      if (first_change(which) == Outcome::unchanged) break;
      fit_.sweep();
    }
    merge_scattered();
    drop_until_accepted();
  }

  // Takes the steps in turn up to the first that changes the set of modes.
  Outcome first_change(ResidualSearch which) {
    for (const Step step : kSteps) {
      if (take(step, which) == Outcome::changed) return Outcome::changed;
    }
    return Outcome::unchanged;
  }

  Outcome take(Step step, ResidualSearch which) {
    switch (step) {
      case Step::drop_insignificant: {
        const Outcome outcome = drop_insignificant();
        if (!residual_search_.has_tried_any()) peak_modes_ = fit_.poles();
        return outcome;
      }
      case Step::split_close:
        return replace_poles(close_search_.next(fit_, context_));
      case Step::add_residual:
        return which == ResidualSearch::none ? Outcome::unchanged : add(residual_search_.next(fit_, which));
    }
    return Outcome::unchanged;
  }

  // Called after the last change of the search. Also drops modes that were kept only because the search might still
  // find another mode beside them.
  void drop_until_accepted() {
    context_.search_finished = true;
    while (drop_insignificant() == Outcome::changed) fit_.sweep();
    for (int pass = 0; pass < kMaxRegroupings && has_outdated_groups(); ++pass) {
      fit_.sweep();
      while (drop_insignificant() == Outcome::changed) fit_.sweep();
    }
  }

  // Whether poles that moved close to each other in the last fits are in different groups, although new groups would
  // fit them together. Two such poles can share one resonance, because each group is fitted without the contribution of
  // the other.
  bool has_outdated_groups() const {
    std::vector<std::pair<Pole, Pole>> apart;
    const std::vector<FitGroup>& groups = fit_.groups();
    for (std::size_t a = 0; a < groups.size(); ++a) {
      for (std::size_t b = a + 1; b < groups.size(); ++b) {
        for (const Pole& of_a : groups[a].fit.poles) {
          for (const Pole& of_b : groups[b].fit.poles)
            if (are_close(of_a, of_b)) apart.emplace_back(of_a, of_b);
        }
      }
    }
    if (apart.empty()) return false;
    const FrfDataset lines{.lines = set_.lines};  // the groups follow from the lines and the poles alone
    WindowedFit anew(lines, options_.windows);
    anew.replace(fit_.poles());
    return std::any_of(apart.begin(), apart.end(), [&](const auto& pair) {
      return std::any_of(anew.groups().begin(), anew.groups().end(), [&](const FitGroup& group) {
        const std::vector<Pole>& poles = group.fit.poles;
        return std::find(poles.begin(), poles.end(), pair.first) != poles.end() &&
               std::find(poles.begin(), poles.end(), pair.second) != poles.end();
      });
    });
  }

  Outcome drop_insignificant() {
    std::vector<Pole> kept;
    for (const FitGroup& group : fit_.groups()) {
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
        const Pole& pole = group.fit.poles[m];
        const bool repeated =
            std::any_of(kept.begin(), kept.end(), [&](const Pole& k) { return poles_coincide(fit_, k, pole); });
        if (!repeated && accept_mode(fit_, group, m, context_)) kept.push_back(pole);
      }
    }
    return replace_poles(std::move(kept));
  }

  // Where several poles only describe the frequency scatter of one mode, replaces them by one pole.
  void merge_scattered() {
    Outcome outcome = Outcome::changed;
    while (outcome == Outcome::changed) {
      std::vector<Pole> kept;
      for (const FitGroup& group : fit_.groups()) {
        if (const auto one = merge_if_scattered(fit_, group)) {
          kept.push_back(*one);
        } else {
          kept.insert(kept.end(), group.fit.poles.begin(), group.fit.poles.end());
        }
      }
      outcome = replace_poles(std::move(kept));
      if (outcome == Outcome::changed) fit_.sweep();
    }
  }

  Outcome add(const std::vector<Pole>& more) {
    std::vector<Pole> poles = fit_.poles();
    poles.insert(poles.end(), more.begin(), more.end());
    return replace_poles(std::move(poles));
  }

  // Every step adds or removes poles: an equal number means the same poles.
  Outcome replace_poles(std::vector<Pole> poles) {
    if (poles.size() == fit_.poles().size()) return Outcome::unchanged;
    fit_.replace(std::move(poles));
    return Outcome::changed;
  }

  const FrfDataset& set_;
  const SequentialFitOptions& options_;
  WindowedFit fit_;
  AcceptanceContext context_;
  CloseModeSearch close_search_;
  ResidualModeSearch residual_search_;
  std::vector<Pole> peak_modes_;  // the accepted modes before the residual was first searched
};

}  // namespace

SequentialFitOptions sequential_fit_options(Effort effort) {
  if (effort == Effort::quick) {
    return {.max_rounds = 3,
            .search_residual = false,
            .windows = {.window_widths = 5, .change_tolerance = 0.1},
            .settle = true};
  }
  return {.settle = effort == Effort::standard};
}

std::vector<FittedMode> fit_sequentially(const FrfDataset& set, const SequentialFitOptions& options) {
  if (set.lines.count < kMinFitLines || set.channels.empty()) return {};
  return SequentialFit(set, options).run();
}

}  // namespace percuss::identify
