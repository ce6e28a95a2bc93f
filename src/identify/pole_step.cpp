#include "identify/pole_step.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {
namespace {

using Eigen::Index;

constexpr double kLeastDamping = 1e-7;
constexpr double kMostDamping = 0.5;
constexpr double kApart = 1e-3;  // bandwidths: closer, the normal equations lose all but a few digits

bool coincide(const Pole& a, const Pole& b) {
  const double width_Hz = std::min(a.half_power_Hz(), b.half_power_Hz());
  const double apart_Hz = std::hypot(a.freq_Hz - b.freq_Hz, 0.5 * (a.half_power_Hz() - b.half_power_Hz()));
  return apart_Hz < kApart * width_Hz;
}

}  // namespace

bool poles_allowed(const std::vector<Pole>& poles) {
  for (std::size_t m = 0; m < poles.size(); ++m) {
    const Pole& p = poles[m];
    if (!(p.freq_Hz > 0 && p.damping_ratio > kLeastDamping && p.damping_ratio < kMostDamping)) return false;
    const auto others = poles.begin() + static_cast<std::ptrdiff_t>(m);
    if (std::any_of(poles.begin(), others, [&](const Pole& other) { return coincide(p, other); })) return false;
  }
  return true;
}

std::vector<Pole> moved_by(std::vector<Pole> poles, const Eigen::VectorXd& step) {
  for (std::size_t m = 0; m < poles.size(); ++m) {
    poles[m].freq_Hz += step(static_cast<Index>(2 * m));
    poles[m].damping_ratio += step(static_cast<Index>(2 * m + 1));
  }
  return poles;
}

double step_size(const Eigen::VectorXd& step, const std::vector<Pole>& poles) {
  double size = 0;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    size = std::max({size, std::abs(step(static_cast<Index>(2 * m))) / (0.5 * poles[m].half_power_Hz()),
                     std::abs(step(static_cast<Index>(2 * m + 1))) / poles[m].damping_ratio});
  }
  return size;
}

}  // namespace percuss
