#include "identify/line_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/statistics.hpp"

namespace percuss {
namespace {

using Eigen::Index;

constexpr double kMedianOfNoise = 0.693147;  // median of an exponential distribution: |complex Gaussian|²
constexpr double kRoughnessGain = 1.5;       // variance of x(k) − (x(k−1) + x(k+1))/2 over that of x
constexpr double kRounding = 1e-12;  // of the largest line: a noise-free FRF still has it; a weight of zero is none
constexpr double kLeastPower = 1e-300;

double response_noise(const std::vector<Complex>& frf, const std::vector<double>& ff) {
  std::vector<double> rough = roughness(frf);
  double largest = 0;
  for (std::size_t k = 0; k < frf.size(); ++k) {
    const double force_power = ff.empty() ? 1.0 : ff[k];
    rough[k] *= force_power;
    largest = std::max(largest, std::norm(frf[k]) * force_power);
  }
  return std::sqrt(std::max({noise_power(rough), kRounding * kRounding * largest, kLeastPower}));
}

}  // namespace

LineNoise::LineNoise(const FrfSet& set) : set_(set), response_(static_cast<Index>(set.outputs.size())) {
  for (std::size_t o = 0; o < set.outputs.size(); ++o)
    response_(static_cast<Index>(o)) = response_noise(set.outputs[o].frf, set.points[set.outputs[o].point].ff);
}

double LineNoise::at(std::size_t output, std::size_t line) const {
  const std::vector<double>& ff = set_.points[set_.outputs[output].point].ff;
  return response_(static_cast<Index>(output)) / (ff.empty() ? 1 : std::sqrt(std::max(ff[line], kLeastPower)));
}

Eigen::VectorXd LineNoise::over(std::size_t first, std::size_t count) const {
  Eigen::VectorXd noise(response_.size());
  for (std::size_t o = 0; o < set_.outputs.size(); ++o) {
    const std::size_t point = set_.outputs[o].point;
    const std::vector<double>& ff = set_.points[point].ff;
    const auto i = static_cast<Index>(o);
    if (o > 0 && set_.outputs[o - 1].point == point) {
      noise(i) = noise(i - 1) * response_(i) / response_(i - 1);
    } else if (ff.empty()) {
      noise(i) = response_(i);
    } else {
      const Eigen::Map<const Eigen::ArrayXd> power(ff.data() + first, static_cast<Index>(count));
      noise(i) = response_(i) / std::sqrt(std::max(power.mean(), kLeastPower));
    }
  }
  return noise;
}

std::vector<double> roughness(std::span<const Complex> lines) {
  std::vector<double> rough(lines.size());
  for (std::size_t k = 1; k + 1 < lines.size(); ++k)
    rough[k] = std::norm(lines[k] - 0.5 * (lines[k - 1] + lines[k + 1])) / kRoughnessGain;
  return rough;
}

std::vector<double> block_noise(std::span<const double> rough) {
  std::vector<double> noise(std::max<std::size_t>(rough.size() / kNoiseBlock, rough.empty() ? 0 : 1));
  for (std::size_t b = 0; b < noise.size(); ++b) {
    const auto from = rough.subspan(b * kNoiseBlock);
    const auto block = b + 1 < noise.size() ? from.first(kNoiseBlock) : from;
    noise[b] = median({block.begin(), block.end()}) / kMedianOfNoise;
  }
  return noise;
}

double noise_power(std::span<const double> rough) { return median(block_noise(rough)); }

}  // namespace percuss
