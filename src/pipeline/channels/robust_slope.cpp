#include "pipeline/channels/robust_slope.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr int kPasses = 10;
constexpr double kFar = 3;                 // standard deviations: farther values weigh ever less
constexpr double kMedianOfSquare = 0.455;  // of a normal variable with variance 1
constexpr double kMinRelativeRms = 1e-12;  // of the residual over the values: below it is rounding

std::vector<double> squares(std::vector<double> values) {
  for (double& value : values) value *= value;
  return values;
}

std::vector<double> residuals_of(std::span<const double> x, std::span<const double> y, double slope) {
  std::vector<double> residual(y.begin(), y.end());
  for (std::size_t i = 0; i < residual.size(); ++i) residual[i] -= slope * x[i];
  return residual;
}

double start_slope(std::span<const double> x, std::span<const double> y) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < x.size(); ++i) slopes.push_back(y[i] / x[i]);
  return median(std::move(slopes));
}

double weighted_rms(std::span<const double> weight, const std::vector<double>& values) {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += weight[i] * values[i] * values[i];
    all += weight[i];
  }
  return all > 0 ? std::sqrt(sum / all) : 0;
}

}  // namespace

RobustSlope robust_slope(std::span<const double> x, std::span<const double> y, std::span<const double> std) {
  const std::size_t n = x.size();
  const double noise2 = median(squares({std.begin(), std.end()}));
  std::vector<double> weight(n), residual;
  RobustSlope out{.slope = start_slope(x, y)};
  double information = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    residual = residuals_of(x, y, out.slope);
    const double scatter2 = std::max(0.0, median(squares(residual)) / kMedianOfSquare - noise2);
    double sum = 0;
    information = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double variance = std::max(std[i] * std[i] + scatter2, 1e-300);
      weight[i] = 1 / variance / (1 + residual[i] * residual[i] / variance / (kFar * kFar));
      sum += weight[i] * x[i] * y[i];
      information += weight[i] * x[i] * x[i];
    }
    out.slope = sum / information;
  }
  residual = residuals_of(x, y, out.slope);
  double spread = 0;
  for (std::size_t i = 0; i < n; ++i) spread += std::pow(weight[i] * x[i] * residual[i], 2);
  const auto count = static_cast<double>(n);
  out.std = std::max(std::sqrt(spread * count / (count - 1)) / information, 1 / std::sqrt(information));
  out.rms = weighted_rms(weight, residual);
  const double without = weighted_rms(weight, {y.begin(), y.end()});
  if (without > 0) out.log_chance = (count - 1) * std::log(std::clamp(out.rms / without, kMinRelativeRms, 1.0));
  return out;
}

}  // namespace percuss::pipeline
