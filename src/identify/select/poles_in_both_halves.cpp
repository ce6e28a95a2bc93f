#include "identify/select/poles_in_both_halves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr std::size_t kHalves = 2;
constexpr std::size_t kDivisions = 64;     // tried
constexpr double kFairShare = 0.2;         // of a mode's Σ|r|²: a half with less hardly shows the mode
constexpr std::size_t kLowBits = 1 << 16;  // divisor: an upper bit of the random number decides
constexpr double kSamePlace = 0.3;         // half-power bandwidths
constexpr double kSameDamping = 0.3;       // of the damping ratio
// A coarse fit serves: places are compared by fractions of a bandwidth.
constexpr int kHalfFitSteps = 40;
constexpr double kHalfFitStep = 1e-3, kHalfFitCost = 1e-4;  // tolerances of the poles, and of the squares

// [points] the half of each point. The first division takes every second point; the others follow a fixed sequence of
// pseudo-random numbers, because on a grid every second point may lie on a node line.
std::vector<std::size_t> division(std::size_t points, std::size_t number) {
  std::vector<std::size_t> half(points);
  std::minstd_rand random(static_cast<std::minstd_rand::result_type>(number + 1));
  for (std::size_t p = 0; p < points; ++p) half[p] = number == 0 ? p % kHalves : random() / kLowBits % kHalves;
  return half;
}

// The smallest part of a mode's Σ|r|² that a half holds, over both halves and all modes.
double least_share(const FrfDataset& set, const Eigen::MatrixXcd& residues, const std::vector<std::size_t>& half) {
  Eigen::MatrixXd power = Eigen::MatrixXd::Zero(static_cast<Index>(kHalves), residues.cols());
  for (std::size_t o = 0; o < set.channels.size(); ++o)
    power.row(static_cast<Index>(half[set.channels[o].point])) += residues.row(static_cast<Index>(o)).cwiseAbs2();
  return (power.colwise().minCoeff().array() / power.colwise().sum().array()).minCoeff();
}

// The first division in which both halves show each mode, else the fairest of all.
std::vector<std::size_t> fair_division(const FrfDataset& set, const std::vector<Pole>& poles) {
  const Eigen::MatrixXcd residues = residues_at(set, poles);
  std::vector<std::size_t> fairest = division(set.points.size(), 0);
  double best = least_share(set, residues, fairest);
  for (std::size_t number = 1; number < kDivisions && best < kFairShare; ++number) {
    std::vector<std::size_t> half = division(set.points.size(), number);
    const double share = least_share(set, residues, half);
    if (!(share > best)) continue;
    best = share;
    fairest = std::move(half);
  }
  return fairest;
}

FrfDataset half_of(const FrfDataset& set, const std::vector<std::size_t>& half, std::size_t which) {
  FrfDataset out{.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz};
  const auto channels = channels_by_point(set);
  for (std::size_t p = 0; p < set.points.size(); ++p) {
    if (half[p] != which) continue;
    for (const std::size_t o : channels[p]) {
      out.channels.push_back(set.channels[o]);
      out.channels.back().point = out.points.size();
    }
    out.points.push_back(set.points[p]);
  }
  return out;
}

bool same(const Pole& a, const Pole& b) {
  return std::abs(a.freq_Hz - b.freq_Hz) < kSamePlace * std::min(a.half_power_Hz(), b.half_power_Hz()) &&
         std::abs(a.damping_ratio - b.damping_ratio) < kSameDamping * std::max(a.damping_ratio, b.damping_ratio);
}

}  // namespace

std::vector<Pole> poles_in_both_halves(const FrfDataset& set, const std::vector<Pole>& poles) {
  const std::vector<std::size_t> half = fair_division(set, poles);
  std::array<JointFit, kHalves> halves;
  for (std::size_t h = 0; h < kHalves; ++h)
    halves[h] = fit_jointly(
        half_of(set, half, h), poles,
        {.max_steps = kHalfFitSteps, .tolerance = kHalfFitStep, .cost_tolerance = kHalfFitCost, .test_real = false});
  std::vector<Pole> kept;
  for (std::size_t m = 0; m < poles.size(); ++m) {
    const Pole &a = halves[0].poles[m], &b = halves[1].poles[m];
    if (same(a, b)) kept.push_back(poles[m]);
  }
  return kept;
}

}  // namespace percuss::identify
