#include "identify/select/residual_mode_search.hpp"

#include <algorithm>
#include <cmath>

#include "identify/select/frequency_scatter.hpp"
#include "identify/start/candidates.hpp"

namespace percuss::identify {
namespace {

constexpr double kScatterExclusion = 10;   // bandwidths from a mode with frequency scatter: half of its window
constexpr double kKnownModeExclusion = 2;  // … from any known mode: CloseModeSearch finds closer modes
// Smallest half-power bandwidth of a broad mode, over the highest line's frequency: about ten times the bandwidth of a
// typical peak.
constexpr double kBroad = 0.02;

// The poles with frequency scatter. Their residual is not a mode; it is removed from `residual`.
std::vector<Pole> scattered_poles(const WindowedFit& all, std::vector<Eigen::VectorXcd>& residual) {
  std::vector<Pole> poles;
  for (const FitGroup& group : all.groups()) {
    if (group.fit.degrees == 0) continue;
    const auto scattered = scattered_modes(all, group);
    for (std::size_t m = 0; m < scattered.size(); ++m) {
      subtract_freq_scatter(all.set(), group, m, scattered[m], residual);
      poles.push_back(group.fit.poles[m]);
    }
  }
  return poles;
}

bool near(const WindowedFit& all, const std::vector<Pole>& list, const Pole& candidate, double widths) {
  return std::any_of(list.begin(), list.end(), [&](const Pole& pole) {
    return std::abs(pole.freq_Hz - candidate.freq_Hz) <= widths * all.width_Hz(pole);
  });
}

}  // namespace

std::vector<Pole> ResidualModeSearch::next(const WindowedFit& all, ResidualSearch which) {
  const std::vector<Pole> known = all.poles();
  std::vector<Eigen::VectorXcd> residual = all.residual();
  const std::vector<Pole> scattered = scattered_poles(all, residual);
  const double broad_Hz = kBroad * all.set().lines.freq_Hz(all.set().lines.count - 1);
  std::vector<Pole> found, rejected;
  for (const Pole& candidate : residual_mode_poles(all.set(), residual)) {
    if (near(all, known, candidate, kKnownModeExclusion) || near(all, scattered, candidate, kScatterExclusion))
      continue;
    if (!near(all, tried_, candidate, 1)) {
      found.push_back(candidate);
    } else if (candidate.half_power_Hz() > broad_Hz && !near(all, alone_, candidate, 1)) {
      rejected.push_back(candidate);
    }
  }
  if (which == ResidualSearch::all && !found.empty()) {
    tried_.insert(tried_.end(), found.begin(), found.end());
    return found;
  }
  rejected.resize(std::min<std::size_t>(rejected.size(), 1));  // the most significant
  alone_.insert(alone_.end(), rejected.begin(), rejected.end());
  return rejected;
}

}  // namespace percuss::identify
