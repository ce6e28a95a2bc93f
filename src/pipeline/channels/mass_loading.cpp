#include "pipeline/channels/mass_loading.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/statistics.hpp"
#include "pipeline/channels/robust_slope.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinPoints = 6;
constexpr double kRoundingOfFreq = 1e-9;  // relative
// Least number of modes whose frequency falls, per mode whose frequency rises. Two close modes that a sensor's mass
// moves across each other can be listed so that one of them seems to rise.
constexpr std::size_t kFallsPerRise = 5;

// Data of a linear regression, one value per point, both about their medians.
struct RegressionData {
  std::vector<double> square;  // squared residue, summed over the channels of a point, over the largest
  std::vector<double> freq;    // relative frequency
};

RegressionData regression_data(const identify::Mode& mode) {
  RegressionData data;
  std::map<std::size_t, std::size_t> place_of;  // in `data`, by point
  for (const identify::Residue& residue : mode.residues) {
    if (!residue.own_pole) continue;
    const auto [at, is_first] = place_of.emplace(residue.point, data.square.size());
    if (is_first) {
      data.square.push_back(0);
      data.freq.push_back(residue.own_pole->freq_Hz / mode.pole.freq_Hz - 1);
    }
    data.square[at->second] += std::norm(residue.value);
  }
  if (data.square.size() < kMinPoints) return {};
  const double most = *std::max_element(data.square.begin(), data.square.end());
  if (!(most > 0)) return {};
  for (double& square : data.square) square /= most;
  for (std::vector<double>* values : {&data.square, &data.freq}) {
    const double middle = median(*values);
    for (double& value : *values) value -= middle;
  }
  return data;
}

// A value at the median says nothing about the slope, and has no quotient.
RegressionData without_middle(const RegressionData& data) {
  RegressionData out;
  for (std::size_t i = 0; i < data.square.size(); ++i) {
    if (data.square[i] == 0) continue;
    out.square.push_back(data.square[i]);
    out.freq.push_back(data.freq[i]);
  }
  return out;
}

}  // namespace

std::vector<MassLoading> mass_loading(const std::vector<identify::Mode>& modes) {
  std::vector<MassLoading> out;
  std::size_t rises = 0;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const RegressionData all = regression_data(modes[m]);
    if (all.square.empty()) continue;
    const RegressionData data = without_middle(all);
    if (data.square.size() + 1 < kMinPoints) continue;
    const std::vector<double> std(data.square.size(), kRoundingOfFreq);
    const RobustSlope slope = robust_slope(data.square, data.freq, std);
    if (slope.log_chance > kMaxLogChance || std::abs(slope.slope) < kSureSlope * slope.std) continue;
    if (slope.slope > 0) {
      ++rises;
    } else {
      out.push_back({.mode = m, .largest_fall = -slope.slope, .std = slope.std, .points = all.square.size()});
    }
  }
  if (out.size() < kFallsPerRise * rises) return {};
  return out;
}

}  // namespace percuss::pipeline
