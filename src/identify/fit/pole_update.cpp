#include "identify/fit/pole_update.hpp"

#include <algorithm>
#include <cmath>

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMinDampingRatio = 1e-7;

}  // namespace

bool poles_in_bounds(const std::vector<Pole>& poles) {
  return std::all_of(poles.begin(), poles.end(), [](const Pole& p) {
    return p.freq_Hz > 0 && p.damping_ratio > kMinDampingRatio && p.damping_ratio < kMaxFittedDamping;
  });
}

std::vector<Pole> updated_poles(std::vector<Pole> poles, const Eigen::VectorXd& step) {
  for (std::size_t m = 0; m < poles.size(); ++m) {
    poles[m].freq_Hz += step(static_cast<Index>(2 * m));
    poles[m].damping_ratio += step(static_cast<Index>(2 * m + 1));
  }
  return poles;
}

double normalised_step(const Eigen::VectorXd& step, const std::vector<Pole>& poles) {
  double size = 0;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    size = std::max({size, std::abs(step(static_cast<Index>(2 * m))) / (0.5 * poles[m].half_power_Hz()),
                     std::abs(step(static_cast<Index>(2 * m + 1))) / poles[m].damping_ratio});
  }
  return size;
}

}  // namespace percuss::identify
