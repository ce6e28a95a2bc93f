#include "identify/select/joint_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "identify/fit/completed_decays.hpp"
#include "identify/fit/joint_fit.hpp"
#include "identify/select/found_before.hpp"
#include "identify/select/joint_fit_budget.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/joint_selection.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/residual_smoothness.hpp"
#include "identify/start/stable_poles.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;

constexpr double kMaxGain = 25, kMinGain = 8;  // likelihood ratio per unknown: as for a close mode; ln of the lines
constexpr double kModeGain = 150;    // … and per mode, where an unknown needs no more and no less than these
constexpr int kDroppingRounds = 12;  // of dropping modes
constexpr int kJointSteps = 40;      // of a joint fit
constexpr std::size_t kMaxJointModes = 150;
constexpr double kMinMisfit = 6;            // standard deviations of the residual's roughness
constexpr double kPairStart = 0.4;          // half-power bandwidths from a mode to either pole of a trial pair
constexpr std::size_t kMaxPairTrials = 6;   // modes tried as a pair in one round
constexpr std::size_t kMaxSplitModes = 40;  // with more modes, no mode is tried as a close pair
constexpr int kLinearRounds = 4;
constexpr int kResidualRounds = 4;
constexpr std::size_t kSharedPoints = 3;  // from which shared columns pay
constexpr double kTrialStep = 1e-3;       // tolerance of the poles while their number changes
constexpr double kTrialCost = 1e-4;       // … and relative decrease of the squares
constexpr double kFinalCost = 1e-9;
constexpr std::size_t kMaxTrials = 27;  // of one more mode

// The starts with significant residues, by linear fits at the starts: a small part of the work.
std::vector<Pole> significant_starts(const FrfDataset& set, std::vector<Pole> poles) {
  for (int round = 0; round < kLinearRounds && !poles.empty(); ++round) {
    const auto unknowns = static_cast<Index>(2 * poles.size());
    std::vector<Pole> kept =
        without_weakest(set, fit_residues(set, poles, MatrixXd::Zero(unknowns, unknowns)), Misfit::counted);
    if (kept.size() == poles.size()) break;
    poles = std::move(kept);
  }
  return poles;
}

// The joint fit from these poles, without insignificant modes; nothing where it does not settle. A coarse tolerance
// serves until no more modes are dropped. A fit that neither converges nor drops a mode is not repeated.
std::optional<JointFit> settled_fit(const FrfDataset& set, std::vector<Pole> poles, JointFitBudget& budget) {
  JointFitOptions options{
      .max_steps = kJointSteps, .tolerance = kTrialStep, .cost_tolerance = kTrialCost, .test_real = false};
  for (int round = 0; round < kDroppingRounds && !poles.empty() && budget.allows(poles); ++round) {
    JointFit fit = budget.fit(poles, options);
    const bool converged = fit.converged;
    const auto unknowns = static_cast<Index>(2 * fit.poles.size());
    if (fit.residual.empty()) fit = fit_residues(set, fit.poles, MatrixXd::Zero(unknowns, unknowns));
    poles = without_weakest(set, fit, Misfit::ignored);
    if (poles.size() < fit.poles.size()) continue;
    if (!converged) break;
    if (options.tolerance < kTrialStep) return fit;
    options.tolerance = JointFitOptions{}.tolerance;
    options.cost_tolerance = kFinalCost;
  }
  return std::nullopt;
}

std::vector<Pole> start_poles(const std::vector<FittedMode>& modes) {
  std::vector<Pole> poles;
  poles.reserve(modes.size());
  for (const FittedMode& mode : modes) poles.push_back(mode.mode.pole);
  return poles;
}

// The starts: the modes found before, and every stable pole that is not one of these modes and around which the
// residual matters. Without noise, rounding errors make a hundred stable poles.
std::vector<Pole> starts_of(const FrfDataset& set, const std::vector<VectorXcd>& residual,
                            const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = stable_poles(set);
  std::erase_if(starts, [&](const Pole& pole) { return !is_material(set, residual, pole); });
  for (const Pole& known : start_poles(modes)) {
    const auto near = [&](const Pole& pole) {
      return std::abs(pole.freq_Hz - known.freq_Hz) < 0.5 * least_width_Hz(set, known) && same_place(pole, known);
    };
    std::erase_if(starts, near);
    starts.push_back(known);
  }
  return starts;
}

std::vector<FittedMode> joint_modes(const FrfDataset& set, const JointFit& fit) {
  std::vector<FittedMode> modes;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    const JointWindow window = window_around(set, fit.poles[m]);
    FittedMode& mode = modes.emplace_back();
    mode.first = static_cast<std::size_t>(window.first);
    mode.count = static_cast<std::size_t>(window.count);
    mode.peak_to_residual = standing_of(set, fit, m, Misfit::ignored).peak_to_residual;
    mode.noise.resize(static_cast<Index>(set.channels.size()));
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      mode.noise(static_cast<Index>(o)) =
          fit.residual[o].segment(window.first, window.count).norm() / std::sqrt(static_cast<double>(window.count));
    }
    take_joint_mode(set, fit, m, mode);
  }
  std::sort(modes.begin(), modes.end(),
            [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
  return modes;
}

// `residual` is that of `modes`.
bool must_search(const FrfDataset& set, const std::vector<VectorXcd>& residual, const std::vector<FittedMode>& modes) {
  const auto scatters = [](const FittedMode& mode) { return mode.mode.freq_scatter_Hz > 0; };
  const auto misfits = [&](const FittedMode& mode) {
    const Pole& pole = mode.mode.pole;
    return misfit_of(set, residual, pole) > kMinMisfit && is_material(set, residual, pole);
  };
  if (std::any_of(modes.begin(), modes.end(), scatters) || std::any_of(modes.begin(), modes.end(), misfits))
    return true;
  if (!smooth_somewhere(residual)) return false;
  const std::vector<Pole> poles = residual_mode_poles(set, residual);
  return std::any_of(poles.begin(), poles.end(), [&](const Pole& pole) { return is_material(set, residual, pole); });
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

std::size_t unknowns_per_mode(const FrfDataset& set) { return 2 + 2 * set.channels.size(); }

// Twice the logarithm of the likelihood that so many more unknowns must gain. Each of the many residues of a mode of a
// survey needs to gain less than each of the few of a single record.
double least_gain(const FrfDataset& set, std::size_t unknowns) {
  const double each = std::clamp(kModeGain / static_cast<double>(unknowns_per_mode(set)), kMinGain, kMaxGain);
  return each * static_cast<double>(unknowns);
}

// Replaces the fit where another gains enough for its additional modes; true where it did.
bool take_if_better(const FrfDataset& set, JointFit& fit, std::optional<JointFit> other) {
  if (!other) return false;
  const std::size_t more = other->poles.size() > fit.poles.size() ? other->poles.size() - fit.poles.size() : 1;
  if (likelihood_ratio(set, fit.residual, other->residual) <= least_gain(set, more * unknowns_per_mode(set)))
    return false;
  fit = *std::move(other);
  return true;
}

// Adds the resonances and the stable poles of the residual, all at once.
JointFit with_residual_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  FrfDataset rest = set;
  for (int round = 0; round < kResidualRounds; ++round) {
    for (std::size_t o = 0; o < rest.channels.size(); ++o)
      rest.channels[o].frf.assign(fit.residual[o].begin(), fit.residual[o].end());
    std::vector<Pole> more = stable_poles(rest);
    for (const Pole& pole : residual_mode_poles(set, fit.residual)) {
      const auto near = [&](const Pole& other) { return same_place(other, pole); };
      if (std::none_of(more.begin(), more.end(), near)) more.push_back(pole);
    }
    if (more.empty() || fit.poles.size() + more.size() > kMaxJointModes) break;
    more.insert(more.end(), fit.poles.begin(), fit.poles.end());
    if (!take_if_better(set, fit, settled_fit(set, std::move(more), budget))) break;
  }
  return fit;
}

// Splits misfitting modes one by one, as long as the likelihood gains.
JointFit with_close_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  std::size_t tried = 0;
  for (bool gained = true; gained && tried < kMaxTrials;) {
    std::optional<JointFit> best;
    for (std::vector<Pole>& poles : with_one_more(set, fit)) {
      ++tried;
      if (!budget.allows(poles)) return fit;
      JointFit trial = budget.fit(std::move(poles), {.max_steps = kJointSteps, .test_real = false});
      if (!trial.converged || without_weakest(set, trial, Misfit::counted).size() != trial.poles.size()) continue;
      if (!best || likelihood_ratio(set, best->residual, trial.residual) > 0) best = std::move(trial);
    }
    gained = take_if_better(set, fit, std::move(best));
  }
  return fit;
}

// Drops modes that only follow the misfit of others.
JointFit without_misfit_modes(const FrfDataset& set, JointFit fit, JointFitBudget& budget) {
  for (int round = 0; round < kDroppingRounds; ++round) {
    std::vector<Pole> kept = without_weakest(set, fit, Misfit::counted);
    if (kept.size() == fit.poles.size()) break;
    std::optional<JointFit> fewer = settled_fit(set, std::move(kept), budget);
    if (!fewer || fewer->poles.size() >= fit.poles.size()) break;
    const double lost = likelihood_ratio(set, fewer->residual, fit.residual);
    if (lost > least_gain(set, (fit.poles.size() - fewer->poles.size()) * unknowns_per_mode(set))) break;
    fit = *std::move(fewer);
  }
  return fit;
}

// The same modes with real residues where the data allow it.
JointFit with_tested_residues(const FrfDataset& set, const JointFit& fit) {
  JointFit tested = fit_jointly(set, fit.poles, {.max_steps = kJointSteps, .cost_tolerance = kFinalCost});
  return tested.converged ? tested : fit;
}

// The better of two joint fits, from the modes found before and from all starts, with the modes of its residual and
// close modes added.
std::optional<JointFit> best_fit(const FrfDataset& set, const std::vector<VectorXcd>& residual,
                                 const std::vector<FittedMode>& modes) {
  std::vector<Pole> starts = starts_of(set, residual, modes);
  if (starts.empty() || starts.size() > kMaxJointModes) return std::nullopt;
  JointFitBudget budget(set);
  std::optional<JointFit> fit = settled_fit(set, start_poles(modes), budget);
  if (starts.size() > modes.size()) {
    std::optional<JointFit> after = settled_fit(set, significant_starts(set, std::move(starts)), budget);
    if (fit) {
      take_if_better(set, *fit, std::move(after));
    } else {
      fit = std::move(after);
    }
  }
  if (!fit) return std::nullopt;
  JointFit grown = with_residual_modes(set, *std::move(fit), budget);
  if (grown.poles.size() <= kMaxSplitModes) grown = with_close_modes(set, std::move(grown), budget);
  return with_tested_residues(set, without_misfit_modes(set, std::move(grown), budget));
}

}  // namespace

// The FRFs for the search. With many points, a start of low damping would give each point columns of its own.
FrfDataset with_shared_columns(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  CompletedDecays completed(set);
  if (set.points.size() < kSharedPoints || set.window_decay_per_s() != 0 || !completed.from_records()) return set;
  const std::vector<Pole> poles = start_poles(modes);
  if (!poles.empty()) completed.add_missing_decays(poles, residues_at(set, poles));
  return completed.set();
}

// The fit without the partners that only describe a frequency's scatter; nothing where it then has no more modes than
// were known.
std::optional<JointFit> without_scatter_partners(const FrfDataset& set, const std::vector<FittedMode>& known,
                                                 JointFit fit) {
  const std::vector<std::size_t> partners = scatter_partners(set, known, fit);
  if (partners.empty()) return fit;
  if (fit.poles.size() - partners.size() <= known.size()) return std::nullopt;
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    if (!std::binary_search(partners.begin(), partners.end(), m)) kept.push_back(fit.poles[m]);
  }
  JointFit fewer = fit_jointly(set, kept, {.max_steps = kJointSteps, .cost_tolerance = kFinalCost, .test_real = false});
  if (!fewer.converged) return std::nullopt;
  return with_tested_residues(set, fewer);
}

void search_jointly(const FrfDataset& set, const std::vector<VectorXcd>& residual, std::vector<FittedMode>& modes) {
  const std::vector<VectorXcd> before = residual_before(set, modes, residual);
  if (!must_search(set, before, modes)) return;
  const FrfDataset shared = with_shared_columns(set, modes);
  std::optional<JointFit> fit = best_fit(shared, before, modes);
  if (fit) fit = without_scatter_partners(shared, modes, *std::move(fit));
  if (!fit) return;
  const std::size_t unknowns = unknowns_of(set, modes), after = fit->poles.size() * (2 + 2 * set.channels.size());
  const double least = least_gain(set, after > unknowns ? after - unknowns : unknowns_per_mode(set));
  if (likelihood_ratio(set, before, fit->residual) < least) return;
  modes = joint_modes(shared, *fit);
}

}  // namespace percuss::identify
