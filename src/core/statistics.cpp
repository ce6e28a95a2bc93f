#include "core/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace percuss {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double robust_std(std::vector<double> values) {
  constexpr double kGaussian = 1.4826022185056018;  // 1/Φ⁻¹(3/4)
  const double centre = median(values);
  for (double& value : values) value = std::abs(value - centre);
  return kGaussian * median(std::move(values));
}

double rms(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace percuss
