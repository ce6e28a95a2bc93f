#include "identify/select/repeated_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percuss::identify {
namespace {

constexpr std::size_t kHalves = 2;
constexpr double kSamePlace = 0.3;    // half-power bandwidths
constexpr double kSameDamping = 0.3;  // of the damping ratio
// A coarse fit serves: places are compared by fractions of a bandwidth.
constexpr int kHalfFitSteps = 40;
constexpr double kHalfFitStep = 1e-3, kHalfFitCost = 1e-4;  // tolerances of the poles, and of the squares

// Every second point, from `first` on.
FrfDataset half_of(const FrfDataset& set, std::size_t first) {
  FrfDataset half{.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
  const auto channels = channels_by_point(set);
  for (std::size_t p = first; p < set.points.size(); p += kHalves) {
    for (const std::size_t o : channels[p]) {
      half.channels.push_back(set.channels[o]);
      half.channels.back().point = half.points.size();
    }
    half.points.push_back(set.points[p]);
  }
  return half;
}

bool same(const Pole& a, const Pole& b) {
  return std::abs(a.freq_Hz - b.freq_Hz) < kSamePlace * std::min(a.half_power_Hz(), b.half_power_Hz()) &&
         std::abs(a.damping_ratio - b.damping_ratio) < kSameDamping * std::max(a.damping_ratio, b.damping_ratio);
}

}  // namespace

std::vector<Pole> poles_in_both_halves(const FrfDataset& set, const std::vector<Pole>& poles) {
  std::array<JointFit, kHalves> halves;
  for (std::size_t h = 0; h < kHalves; ++h)
    halves[h] = fit_jointly(
        half_of(set, h), poles,
        {.max_steps = kHalfFitSteps, .tolerance = kHalfFitStep, .cost_tolerance = kHalfFitCost, .test_real = false});
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    const Pole &a = halves[0].poles[m], &b = halves[1].poles[m];
    if (same(a, b)) kept.push_back(poles[m]);
  }
  return kept;
}

}  // namespace percuss::identify
