#include "identify/quick.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/statistics.hpp"
#include "identify/candidates.hpp"

namespace percuss {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int kSweeps = 2;             // after a change each window sees its neighbours' final shares in the second
constexpr int kRounds = 6;             // of dropping, splitting and looking for hidden modes
constexpr double kWindow = 10;         // half-power bandwidths on either side: beyond lies under 0.1 % of a mode's information
constexpr double kLeastLines = 8;      // … and never fewer lines
constexpr double kMostLines = 400;     // … nor more: the linear residual holds over a short stretch only
constexpr double kTogether = 4;        // bandwidths apart at which two modes are fitted together
constexpr std::size_t kMostTogether = 4;
constexpr double kSplitGain = 0.25;    // a second mode must leave at most this part of the residual's energy
constexpr double kSplitTest = 25;      // F statistic
constexpr double kLeastSplit = 0.5;    // bandwidths between the two modes of a split
constexpr double kMisfit = 1.4;        // rms residual over the noise from which a second mode could leave a quarter of the energy
constexpr double kHiddenApart = 2;     // bandwidths from a known mode: closer ones are found by splitting
constexpr double kSignificant = 6;     // deviations of a residue
constexpr double kStandsOut = 3;       // a mode's peak over the rms residual of its window
constexpr double kMostMisfit = 8;      // times: a mode 24 times the residual is one however poor the fit
constexpr double kBeyondReach = 12;     // times: where the force has sunk into its own spectrum's side lobes, small peaks are not modes
constexpr double kMostDamping = 0.3;
constexpr double kDynamicRange = 1e-5;   // of the largest line: smaller peaks cannot be told from what the polynomial leaves
constexpr std::size_t kLeastForFit = 16;  // lines

struct Group {
  LocalFit fit;
  std::size_t first = 0, count = 0;
};

class Quick {
 public:
  Quick(const FrfSet& set, const QuickOptions& options) : set_(set), options_(options), noise_(roughness(set)), largest_(VectorXd::Zero(noise_.size())) {
    for (std::size_t o = 0; o < set.outputs.size(); ++o) {
      for (const Complex& line : set.outputs[o].frf) largest_(static_cast<Index>(o)) = std::max(largest_(static_cast<Index>(o)), std::abs(line));
    }
  }

  std::vector<Mode> run() {
    std::vector<Pole> poles;
    for (const double freq_Hz : options_.start_Hz) poles.push_back(pole_near(set_, freq_Hz));
    if (options_.start_Hz.empty()) poles = candidate_poles(set_);
    shown_ = poles;
    regroup(poles);
    sweep(kSweeps);
    if (options_.start_Hz.empty()) {
      for (int round = 0; round < kRounds; ++round) {
        const bool dropped = drop_insignificant();
        // A residual is searched for hidden modes only when no pair is left in it to be split.
        const bool changed = split_groups() || dropped || add_hidden();
        if (!changed) break;
        sweep(kSweeps);
      }
      settled_ = true;
      while (drop_insignificant()) sweep(kSweeps);
    }
    return modes();
  }

 private:
  void sweep(int times) {
    for (int i = 0; i < times; ++i) {
      if (i > 0) regroup(all_poles());
      for (Group& group : groups_) refit(group);
    }
  }

  std::vector<Pole> all_poles() const {
    std::vector<Pole> poles;
    for (const Group& group : groups_) poles.insert(poles.end(), group.fit.poles.begin(), group.fit.poles.end());
    return poles;
  }

  double width_of(const Pole& pole) const { return std::max(pole.half_power_Hz(), 0.5 * set_.lines.df_Hz()); }

  void place_window(Group& group) const {
    double low = 1e300;
    double high = 0;
    for (const Pole& pole : group.fit.poles) {
      const double half = std::clamp(kWindow * width_of(pole), kLeastLines * set_.lines.df_Hz(), kMostLines * set_.lines.df_Hz());
      low = std::min(low, pole.freq_Hz - half);
      high = std::max(high, pole.freq_Hz + half);
    }
    const auto line = [&](double freq_Hz) {
      const double at = std::round(freq_Hz / set_.lines.df_Hz()) - static_cast<double>(set_.lines.first);
      return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(set_.lines.count - 1)));
    };
    // Twice as many lines as complex unknowns at the least, also for a group at the band's edge.
    const auto least = 2 * (group.fit.poles.size() + LocalFitOptions{}.residual_terms) + 2;
    group.first = line(low);
    std::size_t last = line(high);
    while (last - group.first + 1 < least && last - group.first + 1 < set_.lines.count) {
      if (group.first > 0) --group.first;
      if (last + 1 < set_.lines.count) ++last;
    }
    group.count = last - group.first + 1;
  }

  // Groups of poles close enough to be fitted together; residues known so far are carried over so that others can be subtracted.
  void regroup(std::vector<Pole> poles) {
    const std::vector<Group> before = std::move(groups_);
    groups_.clear();
    std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) { return a.freq_Hz < b.freq_Hz; });
    for (const Pole& pole : poles) {
      const bool near = !groups_.empty() && groups_.back().fit.poles.size() < kMostTogether && pole.freq_Hz - groups_.back().fit.poles.back().freq_Hz <
                                                kTogether * std::max(width_of(pole), width_of(groups_.back().fit.poles.back()));
      if (!near) groups_.emplace_back();
      groups_.back().fit.poles.push_back(pole);
    }
    const auto outputs = static_cast<Index>(set_.outputs.size());
    for (Group& group : groups_) {
      group.fit.residues = Eigen::MatrixXcd::Zero(outputs, static_cast<Index>(group.fit.poles.size()));
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) carry_over(before, group, m);
      place_window(group);
    }
  }

  static void carry_over(const std::vector<Group>& before, Group& group, std::size_t m) {
    for (const Group& old : before) {
      for (std::size_t i = 0; i < old.fit.poles.size(); ++i) {
        if (old.fit.poles[i].freq_Hz != group.fit.poles[m].freq_Hz || old.fit.residues.size() == 0) continue;
        group.fit.residues.col(static_cast<Index>(m)) = old.fit.residues.col(static_cast<Index>(i));
      }
    }
  }

  // The window's lines with every other group's share taken away.
  std::vector<VectorXcd> remainder(const Group& group) const {
    std::vector<VectorXcd> data;
    for (const Output& output : set_.outputs) {
      data.emplace_back(Eigen::Map<const VectorXcd>(output.frf.data() + group.first, static_cast<Index>(group.count)));
    }
    for (const Group& other : groups_) {
      if (&other == &group || other.fit.residues.isZero(0)) continue;
      for (std::size_t m = 0; m < other.fit.poles.size(); ++m) {
        for (std::size_t p = 0; p < set_.points.size(); ++p) {
          const ModeColumn column = mode_column(other.fit.poles[m], set_.points[p], set_.lines, group.first, group.count);
          for (std::size_t o = 0; o < set_.outputs.size(); ++o) {
            if (set_.outputs[o].point != p) continue;
            data[o] -= column.value * other.fit.residues(static_cast<Index>(o), static_cast<Index>(m));
          }
        }
      }
    }
    return data;
  }

  LocalFit fit(const Group& group, const std::vector<VectorXcd>& data, std::vector<Pole> start, const VectorXd& weight) const {
    return fit_locally(set_, data, weight, std::move(start), {.first = group.first, .count = group.count});
  }

  // Twice: the first residual tells each output's noise here, which is not the noise elsewhere.
  void refit(Group& group) const {
    const auto data = remainder(group);
    group.fit = fit(group, data, group.fit.poles, noise_);
    group.fit = fit(group, data, group.fit.poles, weights_from(group.fit));
  }

  VectorXd weights_from(const LocalFit& fit) const {
    VectorXd weight = fit.noise;
    for (Index o = 0; o < weight.size(); ++o) weight(o) = std::max(weight(o), 1e-3 * noise_(o));
    return weight;
  }

  double significance(const LocalFit& fit, std::size_t m) const {
    double best = 0;
    for (Index o = 0; o < fit.residues.rows(); ++o) {
      const double std = fit.residue_std(o, static_cast<Index>(m));
      best = std::max(best, std > 0 ? std::abs(fit.residues(o, static_cast<Index>(m))) / std : 1e9);
    }
    return best;
  }

  // How far the mode's own peak stands out of what the window's fit leaves, at the output where it does most.
  double stands_out(const LocalFit& fit, std::size_t m) const {
    double best = 0;
    for (Index o = 0; o < fit.residues.rows(); ++o) {
      const double peak = std::abs(fit.residues(o, static_cast<Index>(m))) / std::max(2 * fit.poles[m].damping_ratio, set_.lines.df_Hz() / fit.poles[m].freq_Hz);
      best = std::max(best, fit.noise(o) > 0 ? peak / fit.noise(o) : 1e9);
    }
    return best;
  }

  // Above the fit's own imperfection at some output.
  bool tall(const LocalFit& fit, std::size_t m) const {
    for (Index o = 0; o < fit.residues.rows(); ++o) {
      if (std::abs(fit.residues(o, static_cast<Index>(m))) / (2 * fit.poles[m].damping_ratio) > kDynamicRange * largest_(o)) return true;
    }
    return false;
  }

  // How far a mode has to stand out: further when it showed no peak of its own where the window's residual is not noise but the model's
  // misfit, which such a mode may be made of; and beyond the hammer's reach.
  double least_standing(const Group& group, std::size_t m) const {
    const Pole& pole = group.fit.poles[m];
    const bool shown = std::any_of(shown_.begin(), shown_.end(), [&](const Pole& peak) { return std::abs(peak.freq_Hz - pole.freq_Hz) < width_of(pole); });
    double misfit = 1;
    for (Index o = 0; o < group.fit.noise.size(); ++o) misfit = std::max(misfit, group.fit.noise(o) / noise_(o));
    const bool reached = set_.reach_Hz <= 0 || pole.freq_Hz <= set_.reach_Hz;
    // Before the set of modes has settled a misfit may be another mode's, still to be found.
    return kStandsOut * (settled_ && !shown ? std::min(misfit, kMostMisfit) : 1) * (reached ? 1 : kBeyondReach);
  }

  bool credible(const Group& group, std::size_t m) const {
    const Pole& pole = group.fit.poles[m];
    if (!tall(group.fit, m)) return false;
    const double low = set_.lines.freq_Hz(group.first);
    const double high = set_.lines.freq_Hz(group.first + group.count - 1);
    return pole.freq_Hz > low && pole.freq_Hz < high && pole.damping_ratio < kMostDamping &&
           significance(group.fit, m) > kSignificant && stands_out(group.fit, m) > least_standing(group, m) &&
           group.fit.freq_std_Hz(static_cast<Index>(m)) < width_of(pole) &&
           group.fit.damping_std(static_cast<Index>(m)) < pole.damping_ratio;
  }

  bool drop_insignificant() {
    std::vector<Pole> kept;
    for (const Group& group : groups_) {
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
        if (credible(group, m)) kept.push_back(group.fit.poles[m]);
      }
    }
    if (kept.size() == all_poles().size()) return false;
    regroup(std::move(kept));
    return true;
  }

  // Modes that the residual over the whole band shows, away from those known.
  bool add_hidden() {
    std::vector<Pole> poles = all_poles();
    Group whole;
    whole.count = set_.lines.count;
    const std::size_t known = poles.size();
    for (const Pole& hidden : hidden_poles(set_, remainder(whole))) {
      const bool apart = std::all_of(poles.begin(), poles.begin() + static_cast<std::ptrdiff_t>(known), [&](const Pole& pole) {
        return std::abs(pole.freq_Hz - hidden.freq_Hz) > kHiddenApart * width_of(pole);
      });
      const bool tried = std::any_of(tried_.begin(), tried_.end(), [&](const Pole& pole) { return std::abs(pole.freq_Hz - hidden.freq_Hz) < width_of(pole); });
      if (!apart || tried) continue;
      poles.push_back(hidden);
      tried_.push_back(hidden);
    }
    if (poles.size() == known) return false;
    regroup(std::move(poles));
    return true;
  }

  // One more mode in each group whose residual a mode explains.
  bool split_groups() {
    std::vector<Pole> poles;
    for (const Group& group : groups_) {
      const auto split = with_one_more(group);
      poles.insert(poles.end(), split.begin(), split.end());
    }
    if (poles.size() == all_poles().size()) return false;
    regroup(std::move(poles));
    return true;
  }

  // More than noise is left at some output.
  bool misfits(const LocalFit& fit) const {
    for (Index o = 0; o < fit.noise.size(); ++o) {
      if (fit.noise(o) > kMisfit * noise_(o)) return true;
    }
    return false;
  }

  std::vector<Pole> with_one_more(const Group& group) const {
    const std::vector<Pole> now = group.fit.poles;
    const auto unknowns = 2 + 2 * set_.outputs.size();
    if (group.fit.degrees <= 2 * unknowns || now.size() >= kMostTogether) return now;  // not fitted yet, or full
    if (!misfits(group.fit)) return now;
    const auto data = remainder(group);
    const VectorXd weight = weights_from(group.fit);
    Group best = group;
    best.fit = fit(group, data, now, weight);
    const double before = best.fit.cost;
    bool found = false;
    for (std::size_t m = 0; m < now.size(); ++m) {
      for (const double side : {-0.4, 0.4}) {
        std::vector<Pole> start = now;
        start[m].freq_Hz -= side * now[m].half_power_Hz();
        start.push_back({.freq_Hz = now[m].freq_Hz + side * now[m].half_power_Hz(), .damping_ratio = now[m].damping_ratio});
        Group trial = group;
        trial.fit = fit(group, data, start, weight);
        if (trial.fit.cost >= best.fit.cost || trial.fit.degrees == 0 || !all_credible(trial)) continue;
        best = std::move(trial);
        found = true;
      }
    }
    if (!found) return now;
    const double test = (before - best.fit.cost) / static_cast<double>(unknowns) / (best.fit.cost / static_cast<double>(best.fit.degrees));
    return best.fit.cost < kSplitGain * before && test > kSplitTest ? best.fit.poles : now;
  }

  // Two modes, not one whose line is bent: apart by half the narrower one's width, and not of wholly unlike damping.
  bool two_modes(const Pole& a, const Pole& b) const {
    const double narrow = std::min(width_of(a), width_of(b));
    const double wide = std::max(width_of(a), width_of(b));
    return std::abs(a.freq_Hz - b.freq_Hz) > std::max(kLeastSplit * narrow, kLeastSplit / 2 * wide);
  }

  bool all_credible(const Group& group) const {
    for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
      if (!credible(group, m)) return false;
      for (std::size_t i = 0; i < m; ++i) {
        if (!two_modes(group.fit.poles[i], group.fit.poles[m])) return false;
      }
    }
    return true;
  }

  // Relative deviation of a point's force spectrum near a line: its channel's noise within the gate.
  double force_deviation(std::size_t point, double freq_Hz) const {
    const PointForce& force = set_.points[point];
    const double at = std::clamp(freq_Hz / set_.lines.df_Hz() - static_cast<double>(set_.lines.first), 0.0, static_cast<double>(set_.lines.count - 1));
    double gated = 0;
    for (const ForceBlock& block : force.blocks) gated += static_cast<double>(std::max(block.force_N.size(), block.whole_N.size()));
    gated /= static_cast<double>(force.blocks.size());
    return force.noise_N * std::sqrt(0.5 * gated / force.ff[static_cast<std::size_t>(at)]);
  }

  std::vector<Mode> modes() const {
    std::vector<Mode> out;
    std::vector<double> rank;
    for (const Group& group : groups_) {
      for (std::size_t m = 0; m < group.fit.poles.size(); ++m) {
        const auto i = static_cast<Index>(m);
        Mode mode{.pole = group.fit.poles[m], .freq_std_Hz = group.fit.freq_std_Hz(i), .damping_std = group.fit.damping_std(i)};
        for (std::size_t o = 0; o < set_.outputs.size(); ++o) {
          mode.residues.push_back({.point = set_.outputs[o].point, .channel = set_.outputs[o].channel,
                                   .value = group.fit.residues(static_cast<Index>(o), i), .std = group.fit.residue_std(static_cast<Index>(o), i),
                                   .relative_std = force_deviation(set_.outputs[o].point, mode.pole.freq_Hz)});
        }
        out.push_back(std::move(mode));
        rank.push_back(stands_out(group.fit, m));
      }
    }
    return most_significant(std::move(out), rank);
  }

  std::vector<Mode> most_significant(std::vector<Mode> found, const std::vector<double>& rank) const {
    if (!options_.modes || found.size() <= *options_.modes) return found;
    std::vector<std::size_t> order(found.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank[a] > rank[b]; });
    order.resize(*options_.modes);
    std::sort(order.begin(), order.end());
    std::vector<Mode> out;
    for (const std::size_t i : order) out.push_back(std::move(found[i]));
    return out;
  }

  const FrfSet& set_;
  const QuickOptions& options_;
  VectorXd noise_, largest_;  // per output: deviation of a line's noise, largest line
  std::vector<Group> groups_;
  std::vector<Pole> shown_;  // those that began as a peak
  std::vector<Pole> tried_;  // hidden modes that were given a chance
  bool settled_ = false;
};

}  // namespace

VectorXd roughness(const FrfSet& set) {
  VectorXd noise(static_cast<Index>(set.outputs.size()));
  for (std::size_t o = 0; o < set.outputs.size(); ++o) {
    const auto& h = set.outputs[o].frf;
    std::vector<double> rough;
    double largest = 0;
    for (std::size_t k = 1; k + 1 < h.size(); ++k) {
      rough.push_back(std::norm(h[k] - 0.5 * (h[k - 1] + h[k + 1])) / 1.5);
      largest = std::max(largest, std::abs(h[k]));
    }
    // A noise-free FRF still has rounding; a weight of zero would be none.
    noise(static_cast<Index>(o)) = std::max({std::sqrt(median(rough) / 0.693147), 1e-12 * largest, 1e-300});
  }
  return noise;
}

std::vector<Mode> identify_quick(const FrfSet& set, const QuickOptions& options) {
  if (set.lines.count < kLeastForFit || set.outputs.empty()) return {};
  return Quick(set, options).run();
}

}  // namespace percuss
