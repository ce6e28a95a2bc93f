#include "identify/select/joint_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "identify/fit/joint_fit.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kChance = 6;  // deviations of χ²: the joint fit is refused where it leaves more than a local one

// What the joint fit leaves in a mode's window beyond the local fit, in the noise's energy: χ² of the unknowns that the
// local fit has and the joint one lacks.
bool joint_fit_is_as_good(const FittedMode& local, const std::vector<Eigen::VectorXcd>& left) {
  double excess = 0;
  for (Index o = 0; o < local.noise.size(); ++o) {
    const auto window =
        left[static_cast<std::size_t>(o)].segment(static_cast<Index>(local.first), static_cast<Index>(local.count));
    const double freedom = 2 * static_cast<double>(local.count) - static_cast<double>(local.unknowns_per_channel);
    const double variance = 0.5 * local.noise(o) * local.noise(o);  // of each real value
    excess += window.squaredNorm() / variance - freedom;
  }
  const double unknowns = static_cast<double>(local.noise.size()) * static_cast<double>(local.unknowns_per_channel);
  return excess <= unknowns + kChance * std::sqrt(2 * unknowns);
}

}  // namespace

void refine_jointly(const FrfDataset& set, std::vector<FittedMode>& modes) {
  std::vector<Pole> start;
  start.reserve(modes.size());
  for (const FittedMode& mode : modes) start.push_back(mode.mode.pole);
  // Where it cannot follow a single mode, its real residues and deviations need not be worked out.
  const auto follows_any = [&](const std::vector<Eigen::VectorXcd>& left) {
    return std::any_of(modes.begin(), modes.end(),
                       [&](const FittedMode& mode) { return joint_fit_is_as_good(mode, left); });
  };
  const JointFit joint = fit_jointly(set, std::move(start), {.worth_continuing = follows_any});
  if (!joint.converged) return;
  const WindowNoise window(set);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (!joint_fit_is_as_good(modes[m], joint.residual)) continue;
    const auto i = static_cast<Index>(m);
    Mode& mode = modes[m].mode;
    modes[m].joint = true;
    mode.pole = joint.poles[m];
    const double of_pole = std::sqrt(window.of_pole(mode.pole)), of_residue = std::sqrt(window.of_residue(mode.pole));
    mode.freq_std_Hz = std::hypot(of_pole * joint.freq_std_Hz(i), kRounding * mode.pole.freq_Hz);
    mode.damping_std = std::hypot(of_pole * joint.damping_std(i), kRoundingDamping * mode.pole.damping_ratio);
    for (std::size_t o = 0; o < set.channels.size(); ++o) {
      mode.residues[o].value = joint.residues(static_cast<Index>(o), i);
      mode.residues[o].std = of_residue * joint.residue_std(static_cast<Index>(o), i);
    }
  }
  // A step may have exchanged close poles.
  std::stable_sort(modes.begin(), modes.end(),
                   [](const FittedMode& a, const FittedMode& b) { return a.mode.pole.freq_Hz < b.mode.pole.freq_Hz; });
}

}  // namespace percuss::identify
