#include "identify/select/residual_mode_search.hpp"

#include <algorithm>
#include <cmath>

#include "identify/select/frequency_scatter.hpp"
#include "identify/start/candidates.hpp"

namespace percuss::identify {
namespace {

constexpr double kScatterExclusion = 10;   // bandwidths from one that moves: as far as its window reaches
constexpr double kKnownModeExclusion = 2;  // … from a known mode: closer ones are found by splitting
constexpr double kBroad = 0.02;            // half-power bandwidth, of the highest line: peaks are a tenth as broad

// Modes that no common pole fits: what is left around them is no mode, and what they leave elsewhere is taken off the
// residual.
std::vector<Pole> scattered_poles(const WindowedFit& all, std::vector<Eigen::VectorXcd>& residual) {
  std::vector<Pole> poles;
  for (const FitGroup& group : all.groups()) {
    if (group.fit.degrees == 0) continue;
    const auto moving = scattered_modes(all, group);
    for (std::size_t m = 0; m < moving.size(); ++m) {
      subtract_freq_scatter(all.set(), group, m, moving[m], residual);
      poles.push_back(group.fit.poles[m]);
    }
  }
  return poles;
}

bool near(const WindowedFit& all, const std::vector<Pole>& list, const Pole& hidden, double widths) {
  return std::any_of(list.begin(), list.end(), [&](const Pole& pole) {
    return std::abs(pole.freq_Hz - hidden.freq_Hz) <= widths * all.width_Hz(pole);
  });
}

}  // namespace

std::vector<Pole> ResidualModeSearch::next(const WindowedFit& all, ResidualSearch which) {
  const std::vector<Pole> known = all.poles();
  std::vector<Eigen::VectorXcd> residual = all.residual();
  const std::vector<Pole> moving = scattered_poles(all, residual);
  const double broad_Hz = kBroad * all.set().lines.freq_Hz(all.set().lines.count - 1);
  std::vector<Pole> found, given_up;
  for (const Pole& hidden : residual_mode_poles(all.set(), residual)) {
    if (near(all, known, hidden, kKnownModeExclusion) || near(all, moving, hidden, kScatterExclusion)) continue;
    if (!near(all, tried_, hidden, 1)) {
      found.push_back(hidden);
    } else if (hidden.half_power_Hz() > broad_Hz && !near(all, alone_, hidden, 1)) {
      given_up.push_back(hidden);
    }
  }
  if (which == ResidualSearch::all && !found.empty()) {
    tried_.insert(tried_.end(), found.begin(), found.end());
    return found;
  }
  given_up.resize(std::min<std::size_t>(given_up.size(), 1));  // the clearest
  alone_.insert(alone_.end(), given_up.begin(), given_up.end());
  return given_up;
}

}  // namespace percuss::identify
