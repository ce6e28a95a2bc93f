#include "identify/select/joint_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "identify/fit/completed_decays.hpp"
#include "identify/select/found_before.hpp"
#include "identify/select/joint_growth.hpp"
#include "identify/select/joint_refinement.hpp"
#include "identify/select/joint_selection.hpp"
#include "identify/select/poles_in_both_halves.hpp"
#include "identify/select/settled_fit.hpp"
#include "identify/start/candidates.hpp"
#include "identify/start/residual_smoothness.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;

constexpr int kFinalFits = 3;             // of settled_fit(): without the scatter partners, a fit may converge slowly
constexpr double kPartnerReach = 5;       // half-power bandwidths: modes nearer to a scatter partner change without it
constexpr int kHalvesRounds = 6;          // of dropping modes that the halves of the points do not repeat
constexpr std::size_t kSharedPoints = 3;  // with fewer points, shared columns save no work

std::vector<FittedMode> joint_modes(const FrfDataset& set, const JointFit& fit) {
  std::vector<FittedMode> modes;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    const JointWindow window = joint_window(set, fit.poles[m]);
    FittedMode& mode = modes.emplace_back();
    mode.first = static_cast<std::size_t>(window.first);
    mode.count = static_cast<std::size_t>(window.count);
    mode.peak_to_residual = significance_of(set, fit, m, Misfit::ignored).peak_to_residual;
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

// True where the residual around a resonance is largest at the first or at the last of all lines: the flank of a mode
// beyond them, which no search finds.
bool rises_to_an_end(const FrfDataset& set, const std::vector<VectorXcd>& residual, const Pole& pole) {
  const JointWindow window = joint_window(set, pole);
  Eigen::VectorXd power = Eigen::VectorXd::Zero(window.count);
  for (const VectorXcd& of_frf : residual) power += of_frf.segment(window.first, window.count).cwiseAbs2();
  Index largest = 0;
  power.maxCoeff(&largest);
  const Index line = window.first + largest;
  return line == 0 || line + 1 == static_cast<Index>(set.lines.count);
}

// `residual` belongs to `modes`.
bool must_search(const FrfDataset& set, const std::vector<VectorXcd>& residual, const std::vector<FittedMode>& modes) {
  const auto scatters = [](const FittedMode& mode) { return mode.mode.freq_scatter_Hz > 0; };
  const auto misfits = [&](const FittedMode& mode) {
    const Pole& pole = mode.mode.pole;
    return misfit_of(set, residual, pole, Tails::removed) > kMinMisfit &&
           is_material(set, residual, pole, Tails::removed);
  };
  if (std::any_of(modes.begin(), modes.end(), scatters) || std::any_of(modes.begin(), modes.end(), misfits))
    return true;
  if (!smooth_somewhere(residual)) return false;
  const std::vector<Pole> poles = residual_mode_poles(set, residual);
  return std::any_of(poles.begin(), poles.end(), [&](const Pole& pole) {
    return is_material(set, residual, pole) && !rises_to_an_end(set, residual, pole);
  });
}

// The FRFs for the search, completed by the decays that the records cut off; nothing where `set` itself is used. A
// truncated decay differs from point to point, so that each point would need columns of its own. Without truncation,
// all points share them.
std::optional<FrfDataset> with_shared_columns(const FrfDataset& set, const std::vector<FittedMode>& modes) {
  if (set.points.size() < kSharedPoints || set.window_decay_per_s() != 0 || !CompletedDecays::truncation_is_known(set))
    return std::nullopt;
  CompletedDecays completed(set);
  const std::vector<Pole> poles = poles_of(modes);
  if (!poles.empty()) completed.add_missing_decays(poles, residues_at(set, poles));
  return std::move(completed).set();
}

// The fit without the partners that only describe a frequency's scatter; nothing where it then has no more modes than
// were known.
std::optional<JointFit> without_scatter_partners(const FrfDataset& set, const std::vector<FittedMode>& known,
                                                 JointFit fit) {
  const std::vector<std::size_t> partners = scatter_partners(set, known, fit);
  if (partners.empty()) return fit;
  if (fit.poles.size() - partners.size() <= known.size()) return std::nullopt;
  const auto is_partner = [&](std::size_t m) { return std::binary_search(partners.begin(), partners.end(), m); };
  // The motion that the partners described becomes misfit. Distant modes would leave their places to describe it.
  const auto is_near = [&](const Pole& pole) {
    return std::any_of(partners.begin(), partners.end(), [&](std::size_t m) {
      return std::abs(pole.freq_Hz - fit.poles[m].freq_Hz) <=
             kPartnerReach * std::max(pole.half_power_Hz(), fit.poles[m].half_power_Hz());
    });
  };
  std::vector<Pole> kept, held;
  for (std::size_t m = 0; m < fit.poles.size(); ++m) {
    if (is_partner(m)) continue;
    kept.push_back(fit.poles[m]);
    if (!is_near(fit.poles[m])) held.push_back(fit.poles[m]);
  }
  JointFitBudget budget(set);
  std::optional<JointFit> fewer = settled_fit(set, std::move(kept), budget, kFinalFits, held);
  if (!fewer || fewer->poles.size() <= known.size()) return std::nullopt;
  return with_tested_residues(set, *fewer, held);
}

// The fit without modes that only one half of the points shows. If the fit of the remaining poles does not settle,
// they are tested again: with still fewer modes it may settle.
JointFit with_modes_of_both_halves(const FrfDataset& set, JointFit fit) {
  JointFitBudget budget(set);
  std::vector<Pole> poles = fit.poles;
  for (int round = 0; round < kHalvesRounds; ++round) {
    std::vector<Pole> kept = poles_in_both_halves(set, poles);
    if (kept.size() == poles.size() || kept.empty()) break;
    const std::optional<JointFit> fewer = settled_fit(set, kept, budget, kFinalFits);
    if (fewer) return with_tested_residues(set, *fewer);
    poles = std::move(kept);
  }
  return fit;
}

}  // namespace

void search_jointly(const FrfDataset& set, const std::vector<VectorXcd>& residual, std::vector<FittedMode>& modes) {
  const std::vector<VectorXcd> before = residual_before(set, modes, residual);
  if (!must_search(set, before, modes)) return;
  const std::optional<FrfDataset> completed = with_shared_columns(set, modes);
  const FrfDataset& shared = completed ? *completed : set;
  std::optional<JointFit> fit = best_joint_fit(shared, before, modes);
  if (fit) fit = without_scatter_partners(shared, modes, *std::move(fit));
  if (!fit) return;
  if (set.points.size() >= kMinDividedPoints) fit = with_modes_of_both_halves(shared, *std::move(fit));
  const std::size_t unknowns = unknowns_of(set, modes), after = fit->poles.size() * unknowns_per_mode(set);
  const std::vector<Pole> known = poles_of(modes);
  const double least = min_gain_beside(set, after > unknowns ? after - unknowns : unknowns_per_mode(set),
                                       clear_modes(shared, {known, before}, *fit).size());
  if (likelihood_ratio_statistic(set, before, fit->residual) < least) return;
  modes = joint_modes(shared, *fit);
}

}  // namespace percuss::identify
