#include "core/math/statistics.hpp"

#include <Eigen/Core>
#include <cmath>

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

Extremes extremes_of(std::span<const double> values) {
  if (values.empty()) return {};
  // Eight independent comparisons at a time, so that none waits for the previous one.
  using Row = Eigen::Array<double, 8, 1>;
  Row low = Row::Constant(values.front());
  Row high = low;
  std::size_t i = 0;
  for (; i + 8 <= values.size(); i += 8) {
    const Eigen::Map<const Row> row(values.data() + i);
    low = low.min(row);
    high = high.max(row);
  }
  Extremes extremes{.low = low.minCoeff(), .high = high.maxCoeff()};
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
