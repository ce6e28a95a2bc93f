#include "core/math/statistics.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/math/wide_loops.hpp"

namespace percuss {
inline namespace core {
namespace {

constexpr double kGaussian = 1.4826022185056018;  // standard deviation over median absolute deviation

// Median of at least one value; changes their order.
double median_within(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

double median(std::vector<double> values) { return values.empty() ? 0 : median_within(values); }

double robust_std(std::vector<double> values) { return spread_of(std::move(values)).robust_std; }

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  const double middle = median_within(values);
  for (double& value : values) value = std::abs(value - middle);
  return {.median = middle, .robust_std = kGaussian * median_within(values)};
}

std::vector<double> subsampled(std::span<const double> values, std::size_t enough) {
  const std::size_t stride = std::max<std::size_t>(1, values.size() / enough);
  std::vector<double> some;
  some.reserve(values.size() / stride + 1);
  for (std::size_t i = 0; i < values.size(); i += stride) some.push_back(values[i]);
  return some;
}

PERCUSS_WIDE_LOOPS Extremes extremes_of(std::span<const double> values) {
  if (values.empty()) return {};
  // Eight independent comparisons at a time, so that none waits for the previous one.
  constexpr std::size_t kLanes = 8;
  const double any = values.front();
  FourDoubles low{any, any, any, any}, high = low, low2 = low, high2 = low, a{}, b{};
  std::size_t i = 0;
  for (; i + kLanes <= values.size(); i += kLanes) {
    std::memcpy(&a, values.data() + i, sizeof(a));
    std::memcpy(&b, values.data() + i + kLanes / 2, sizeof(b));
    low = low < a ? low : a;
    low2 = low2 < b ? low2 : b;
    high = high > a ? high : a;
    high2 = high2 > b ? high2 : b;
  }
  Extremes extremes{.low = any, .high = any};
  for (std::size_t k = 0; k < kLanes / 2; ++k) {
    extremes.low = std::min({extremes.low, low[k], low2[k]});
    extremes.high = std::max({extremes.high, high[k], high2[k]});
  }
  for (; i < values.size(); ++i) {
    extremes.low = std::min(extremes.low, values[i]);
    extremes.high = std::max(extremes.high, values[i]);
  }
  return extremes;
}

std::vector<Extremes> block_extremes(std::span<const double> values, std::size_t block) {
  std::vector<Extremes> blocks;
  blocks.reserve(values.size() / block + 1);
  for (std::size_t i = 0; i < values.size(); i += block)
    blocks.push_back(extremes_of(values.subspan(i, std::min(block, values.size() - i))));
  return blocks;
}

Extremes extremes_of(std::span<const Extremes> blocks) {
  if (blocks.empty()) return {};
  Extremes all = blocks.front();
  for (const Extremes& block : blocks) all = {std::min(all.low, block.low), std::max(all.high, block.high)};
  return all;
}

double rms(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double rms_about_mean(std::span<const double> values) {
  if (values.empty()) return 0;
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
  return std::sqrt((all - all.mean()).square().mean());
}

}  // namespace core
}  // namespace percuss
