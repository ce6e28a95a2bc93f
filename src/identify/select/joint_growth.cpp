#include "identify/select/joint_growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "identify/select/crowded_fit.hpp"
#include "identify/select/joint_fit_budget.hpp"
#include "identify/select/joint_selection.hpp"
#include "identify/select/settled_fit.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/stable_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::VectorXcd;

constexpr int kMisfitRounds = 12;  // of dropping modes that follow a misfit
constexpr std::size_t kMaxJointModes = 150;
constexpr double kPairStart = 0.4;          // half-power bandwidths from a mode to either pole of a trial pair
constexpr int kPairSteps = 40;              // of the fit of a trial pair
constexpr std::size_t kMaxPairTrials = 6;   // modes tried as a pair in one round
constexpr std::size_t kMaxSplitModes = 40;  // with more modes, no mode is tried as a close pair
constexpr int kLinearRounds = 4;
constexpr int kResidualRounds = 4;
constexpr std::size_t kMaxTrials = 27;  // of one more mode

// The starts with significant residues beside the `known` poles, by linear fits at the starts: a small part of the
// work. Insignificant starts would take all evaluations of the joint fit.
std::vector<Pole> significant_starts(const FrfDataset& set, std::vector<Pole> starts, const std::vector<Pole>& known) {
  for (int round = 0; round < kLinearRounds && !starts.empty(); ++round) {
    std::vector<Pole> poles = starts;
    poles.insert(poles.end(), known.begin(), known.end());
    const std::vector<Pole> kept = without_weakest(set, fit_residues(set, poles), Misfit::counted);
    const auto dropped = std::erase_if(
        starts, [&](const Pole& start) { return std::find(kept.begin(), kept.end(), start) == kept.end(); });
    if (dropped == 0) break;
  }
  return starts;
}

// The starts: the modes found before, and every stable pole that is not one of these modes and around which the
// residual matters. Without noise, rounding errors make a hundred stable poles. A misfitting mode may be two close
// modes fitted as one: the stable poles near it replace it.
std::vector<Pole> starts_of(const FrfDataset& set, const std::vector<VectorXcd>& residual,
                            const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = stable_poles(set);
  std::erase_if(starts, [&](const Pole& pole) { return !is_material(set, residual, pole); });
  for (const Pole& known : poles_of(modes)) {
    const auto near = [&](const Pole& pole) {
      return std::abs(pole.freq_Hz - known.freq_Hz) < 0.5 * resolved_width_Hz(known, set.lines) &&
             same_place(pole, known);
    };
    if (misfit_of(set, residual, known) > kMinMisfit && std::any_of(starts.begin(), starts.end(), near)) continue;
    std::erase_if(starts, near);
    starts.push_back(known);
  }
  return starts;
}

// Whether another fit gains enough for its additional modes. `clear`: the number of clear modes among them.
bool is_better(const FrfDataset& set, const JointFit& fit, const JointFit& other, std::size_t clear) {
  const std::size_t more = other.poles.size() > fit.poles.size() ? other.poles.size() - fit.poles.size() : 1;
  return likelihood_ratio_statistic(set, fit.residual, other.residual) >
         min_gain_beside(set, more * unknowns_per_mode(set), clear);
}

std::vector<Pole> clear_modes_beside(const FrfDataset& set, const JointFit& fit, const JointFit& other) {
  return clear_modes(set, {fit.poles, fit.residual}, other);
}

// Replaces the fit where another is better; true where it did.
bool take_if_better(const FrfDataset& set, JointFit& fit, std::optional<JointFit> other) {
  if (!other || !is_better(set, fit, *other, clear_modes_beside(set, fit, *other).size())) return false;
  fit = *std::move(other);
  return true;
}

// As above. Many weak modes may hide that some are clear: then only the clear modes are added to the fit.
bool take_all_or_clear(const FrfDataset& set, JointFit& fit, std::optional<JointFit> other, JointFitBudget& budget) {
  if (!other) return false;
  const std::vector<Pole> clear = clear_modes_beside(set, fit, *other);
  if (is_better(set, fit, *other, clear.size())) {
    fit = *std::move(other);
    return true;
  }
  if (clear.empty() || fit.poles.size() + clear.size() >= other->poles.size()) return false;
  std::vector<Pole> poles = fit.poles;
  poles.insert(poles.end(), clear.begin(), clear.end());
  return take_if_better(set, fit, settled_fit(set, std::move(poles), budget));
}

// The resonances and stable poles of the fit's residual.
std::vector<Pole> residual_starts(const FrfDataset& set, const JointFit& fit) {
  FrfDataset rest = set;
  for (std::size_t o = 0; o < rest.channels.size(); ++o)
    rest.channels[o].frf.assign(fit.residual[o].begin(), fit.residual[o].end());
  std::vector<Pole> starts = stable_poles(rest);
  for (const Pole& pole : residual_mode_poles(set, fit.residual)) {
    const auto near = [&](const Pole& other) { return same_place(other, pole); };
    if (std::none_of(starts.begin(), starts.end(), near)) starts.push_back(pole);
  }
  if (fit.poles.size() + starts.size() > kMaxJointModes) return {};
  return starts;
}

// The starts that are as significant as a mode, the clearest first, without those within a bandwidth of a mode.
std::vector<Pole> clear_starts(const FrfDataset& set, std::vector<Pole> starts, const JointFit& fit) {
  std::erase_if(starts, [&](const Pole& start) {
    return std::any_of(fit.poles.begin(), fit.poles.end(), [&](const Pole& pole) {
      return std::abs(start.freq_Hz - pole.freq_Hz) < resolved_width_Hz(pole, set.lines);
    });
  });
  if (starts.empty()) return starts;
  std::vector<Pole> all = starts;
  all.insert(all.end(), fit.poles.begin(), fit.poles.end());
  const JointFit linear = fit_residues(set, all);
  std::vector<std::pair<double, std::size_t>> ranks;
  for (std::size_t m = 0; m < starts.size(); ++m) {
    const double significance = significance_of(set, linear, m, Misfit::counted).significance;
    if (significance > kJointSignificance) ranks.emplace_back(-significance, m);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<Pole> clear;
  clear.reserve(ranks.size());
  for (const auto& [rank, m] : ranks) clear.push_back(starts[m]);
  return clear;
}

// Adds modes that the residual shows. Each round tries the clear resonances, then the clearest alone, then all
// significant ones, then all, until one of these is taken. The order matters: starts close to a mode, and starts that
// follow the misfit of a missing mode, make a fit so slow that it takes all evaluations. While strong modes are
// missing, their residual hides the others, and none may be significant.
JointFit with_residual_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  for (int round = 0; round < kResidualRounds; ++round) {
    const std::vector<Pole> all = residual_starts(set, fit);
    const std::vector<Pole> significant = significant_starts(set, all, fit.poles);
    const std::vector<Pole> clear = clear_starts(set, significant, fit);
    const auto taken = [&](std::size_t count, const std::vector<Pole>& from) {
      if (count == 0) return false;
      std::vector<Pole> poles(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
      poles.insert(poles.end(), fit.poles.begin(), fit.poles.end());
      return take_all_or_clear(set, fit, settled_fit(set, std::move(poles), budget), budget);
    };
    if (taken(clear.size(), clear) || (clear.size() > 1 && taken(1, clear))) continue;
    if (significant.size() > clear.size() && taken(significant.size(), significant)) continue;
    if (all.size() <= significant.size() || !taken(all.size(), all)) break;
  }
  return fit;
}

// The poles with one more: each misfitting mode as a close pair.
std::vector<std::vector<Pole>> with_one_more(const FrfDataset& set, const JointFit& fit) {
  std::vector<std::pair<double, std::size_t>> misfits;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    const double misfit = misfit_of(set, fit.residual, fit.poles[m]);
    if (misfit > kMinMisfit) misfits.emplace_back(misfit, m);
  }
  std::sort(misfits.rbegin(), misfits.rend());
  misfits.resize(std::min(misfits.size(), kMaxPairTrials));
  std::vector<std::vector<Pole>> trials;
  for (const auto& [misfit, m] : misfits) {
    Pole beside = fit.poles[m];
    beside.freq_Hz += kPairStart * beside.half_power_Hz();
    trials.push_back(fit.poles);
    trials.back()[m].freq_Hz -= kPairStart * beside.half_power_Hz();
    trials.back().push_back(beside);
  }
  return trials;
}

// Splits misfitting modes one by one, as long as the likelihood gains.
JointFit with_close_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  std::size_t tried = 0;
  for (bool gained = true; gained && tried < kMaxTrials;) {
    std::optional<JointFit> best;
    for (std::vector<Pole>& poles : with_one_more(set, fit)) {
      ++tried;
      if (!budget.allows(poles)) return fit;
      JointFit trial = budget.fit(std::move(poles), {.max_steps = kPairSteps, .test_real = false});
      if (!trial.converged || without_weakest(set, trial, Misfit::counted).size() != trial.poles.size()) continue;
      if (!best || likelihood_ratio_statistic(set, best->residual, trial.residual) > 0) best = std::move(trial);
    }
    gained = take_if_better(set, fit, std::move(best));
  }
  return fit;
}

// Drops modes that only follow the misfit of others.
JointFit without_misfit_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  for (int round = 0; round < kMisfitRounds; ++round) {
    std::vector<Pole> kept = without_weakest(set, fit, Misfit::counted);
    if (kept.size() == fit.poles.size()) break;
    std::optional<JointFit> fewer = settled_fit(set, std::move(kept), budget);
    if (!fewer || fewer->poles.size() >= fit.poles.size()) break;
    const double lost = likelihood_ratio_statistic(set, fewer->residual, fit.residual);
    if (lost > min_gain(set, (fit.poles.size() - fewer->poles.size()) * unknowns_per_mode(set))) break;
    fit = *std::move(fewer);
  }
  return fit;
}

}  // namespace

std::optional<JointFit> best_joint_fit(const FrfDataset& set, const std::vector<VectorXcd>& residual,
                                       const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = starts_of(set, residual, modes);
  if (starts.empty() || starts.size() > kMaxJointModes) return std::nullopt;
  if (std::optional<JointFit> fit = crowded_fit(set, starts, poles_of(modes))) return fit;
  JointFitBudget budget(set);
  std::optional<JointFit> fit = settled_fit(set, poles_of(modes), budget);
  if (starts.size() > modes.size()) {
    std::optional<JointFit> after = settled_fit(set, significant_starts(set, std::move(starts), {}), budget);
    if (fit) {
      take_all_or_clear(set, *fit, std::move(after), budget);
    } else {
      fit = std::move(after);
    }
  }
  if (!fit) return std::nullopt;
  JointFit grown = with_residual_modes(set, *std::move(fit), budget);
  if (grown.poles.size() <= kMaxSplitModes) grown = with_close_modes(set, std::move(grown), budget);
  return with_tested_residues(set, without_misfit_modes(set, std::move(grown), budget));
}

}  // namespace percuss::identify
