#include "identify/select/joint_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identify/fit/joint_fit.hpp"
#include "identify/noise/force_noise.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kChance = 6;  // standard deviations of χ²: beyond it the joint fit is worse than the local one

// In a mode's window, the joint fit leaves more residual energy than the local fit. The excess is χ² distributed; its
// degrees of freedom are the unknowns that only the local fit has.
bool joint_fit_is_as_good(const FittedMode& local, const std::vector<Eigen::VectorXcd>& residual) {
  double excess = 0;
  for (Index o = 0; o < local.noise.size(); ++o) {
    const auto window =
        residual[static_cast<std::size_t>(o)].segment(static_cast<Index>(local.first), static_cast<Index>(local.count));
    const double freedom = 2 * static_cast<double>(local.count) - static_cast<double>(local.unknowns_per_channel);
    const double variance = 0.5 * local.noise(o) * local.noise(o);  // of the real and of the imaginary part
    excess += window.squaredNorm() / variance - freedom;
  }
  const double unknowns = static_cast<double>(local.noise.size()) * static_cast<double>(local.unknowns_per_channel);
  return excess <= unknowns + kChance * std::sqrt(2 * unknowns);
}

// Residual energy of the joint fit over the local fit's, in the mode's window.
double energy_ratio(const FittedMode& local, const std::vector<Eigen::VectorXcd>& residual) {
  double joint = 0, alone = 0;
  for (Index o = 0; o < local.noise.size(); ++o) {
    const auto first = static_cast<Index>(local.first), count = static_cast<Index>(local.count);
    joint += residual[static_cast<std::size_t>(o)].segment(first, count).squaredNorm() / std::pow(local.noise(o), 2);
    alone += static_cast<double>(local.count) - 0.5 * static_cast<double>(local.unknowns_per_channel);
  }
  return alone > 0 ? joint / alone : 0;
}

// Residual of the joint fit relative to the FRFs, in the mode's window.
double relative_residual(const FrfDataset& set, const FittedMode& local,
                         const std::vector<Eigen::VectorXcd>& residual) {
  double left = 0, all = 0;
  for (std::size_t o = 0; o < residual.size(); ++o) {
    left += residual[o].segment(static_cast<Index>(local.first), static_cast<Index>(local.count)).squaredNorm();
    for (std::size_t k = local.first; k < local.first + local.count; ++k) all += std::norm(set.channels[o].frf[k]);
  }
  return all > 0 ? std::sqrt(left / all) : 0;
}

}  // namespace

void take_joint_mode(const FrfDataset& set, const JointFit& joint, std::size_t m, FittedMode& found) {
  const WindowNoise window(set);
  const auto i = static_cast<Index>(m);
  Mode& mode = found.mode;
  found.joint = true;
  mode.pole = joint.poles[m];
  const double of_pole = std::sqrt(window.of_pole(mode.pole));
  // A pole fitted to one FRF doubles the variance of its residue. Fitted to n FRFs, it adds only 1/n.
  const double by_pole = 1 / static_cast<double>(set.channels.size());
  const double of_residue =
      std::sqrt((window.of_residue(mode.pole) + by_pole * window.of_residue_by_pole(mode.pole)) / (1 + by_pole));
  mode.freq_std_Hz = std::hypot(of_pole * joint.freq_std_Hz(i), kRounding * mode.pole.freq_Hz);
  mode.damping_std = std::hypot(of_pole * joint.damping_std(i), kRoundingDamping * mode.pole.damping_ratio);
  const bool is_new = mode.residues.empty();
  mode.residues.resize(set.channels.size());
  for (std::size_t o = 0; o < set.channels.size(); ++o) {
    Residue& residue = mode.residues[o];
    residue.point = set.channels[o].point;
    residue.channel = set.channels[o].channel;
    residue.value = joint.residues(static_cast<Index>(o), i);
    residue.std = of_residue * joint.residue_std(static_cast<Index>(o), i);
    if (is_new) residue.relative_std = gain_amplitude_std(set, residue.point, mode.pole.freq_Hz);
  }
}

std::vector<Eigen::VectorXcd> refine_jointly(const FrfDataset& set, std::vector<FittedMode>& modes) {
  std::vector<Pole> start;
  start.reserve(modes.size());
  for (const FittedMode& mode : modes) start.push_back(mode.mode.pole);
  for (FittedMode& mode : modes) mode.mode.joint_misfit = std::numeric_limits<double>::infinity();
  // A joint fit that is worse for every mode needs no real residues and no standard deviations.
  const auto is_good_for_any = [&](const std::vector<Eigen::VectorXcd>& residual) {
    for (FittedMode& mode : modes) {
      mode.mode.joint_misfit = energy_ratio(mode, residual);
      mode.mode.joint_residual = relative_residual(set, mode, residual);
    }
    return std::any_of(modes.begin(), modes.end(),
                       [&](const FittedMode& mode) { return joint_fit_is_as_good(mode, residual); });
  };
  const JointFit joint = fit_jointly(set, std::move(start), {.worth_continuing = is_good_for_any});
  if (!joint.converged) return {};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].mode.joint_misfit = energy_ratio(modes[m], joint.residual);
    modes[m].mode.joint_residual = relative_residual(set, modes[m], joint.residual);
    if (!joint_fit_is_as_good(modes[m], joint.residual)) continue;
    modes[m].mode.joint_misfit = 0;
    take_joint_mode(set, joint, m, modes[m]);
  }
  // The fit may have exchanged close poles.
  std::stable_sort(modes.begin(), modes.end(),
                   [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
  return joint.residual;
}

}  // namespace percuss::identify
