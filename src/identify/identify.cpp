#include "identify/identify.hpp"

#include <algorithm>
#include <cmath>

#include "identify/joint_fit.hpp"
#include "identify/peak_fit.hpp"

namespace percuss {
namespace {

using Eigen::Index;

constexpr double kChance = 6;  // deviations of χ²: the joint fit is refused where it leaves more than a local one

// What the joint fit leaves in a mode's window beyond the local fit, in the noise's energy: χ² of the unknowns that the
// local fit has and the joint one lacks.
bool agrees(const PeakMode& local, const JointFit& joint) {
  double excess = 0;
  for (Index o = 0; o < local.noise.size(); ++o) {
    const auto window = joint.residual[static_cast<std::size_t>(o)].segment(static_cast<Index>(local.first),
                                                                            static_cast<Index>(local.count));
    const double freedom = 2 * static_cast<double>(local.count) - static_cast<double>(local.unknowns_per_output);
    const double variance = 0.5 * local.noise(o) * local.noise(o);  // of each real value
    excess += window.squaredNorm() / variance - freedom;
  }
  const double unknowns = static_cast<double>(local.noise.size()) * static_cast<double>(local.unknowns_per_output);
  return excess <= unknowns + kChance * std::sqrt(2 * unknowns);
}

void refine(const FrfSet& set, std::vector<PeakMode>& modes) {
  std::vector<Pole> start;
  for (const PeakMode& mode : modes) start.push_back(mode.mode.pole);
  const JointFit joint = fit_jointly(set, std::move(start));
  if (!joint.converged) return;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (!agrees(modes[m], joint)) continue;
    const auto i = static_cast<Index>(m);
    Mode& mode = modes[m].mode;
    mode.pole = joint.poles[m];
    mode.freq_std_Hz = std::hypot(joint.freq_std_Hz(i), kRounding * mode.pole.freq_Hz);
    mode.damping_std = std::hypot(joint.damping_std(i), kRoundingDamping * mode.pole.damping_ratio);
    for (std::size_t o = 0; o < set.outputs.size(); ++o) {
      mode.residues[o].value = joint.residues(static_cast<Index>(o), i);
      mode.residues[o].std = joint.residue_std(static_cast<Index>(o), i);
    }
  }
}

}  // namespace

const char* name_of(Effort effort) {
  switch (effort) {
    case Effort::quick:
      return "quick";
    case Effort::standard:
      return "standard";
    case Effort::best:
      return "best";
  }
  return "";
}

std::vector<Mode> identify_modes(const FrfSet& set, const IdentifyOptions& options) {
  auto found = fit_peaks(
      set, {.thorough = options.effort != Effort::quick, .modes = options.modes, .start_Hz = options.start_Hz});
  if (options.effort == Effort::best && !found.empty()) refine(set, found);
  std::vector<Mode> modes;
  modes.reserve(found.size());
  for (PeakMode& mode : found) modes.push_back(std::move(mode.mode));
  return modes;
}

}  // namespace percuss
