#include "identify/select/robust_mean.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/math/random_effects.hpp"
#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

constexpr double kOutlier = 3;     // standard deviations from the median
constexpr double kNodeSize = 0.3;  // of the median residue: a smaller one is near a node

// Adds an outlier's distance from the median to its standard deviation: it lies far outside the scatter of the other
// values.
std::vector<double> widened_at_outliers(const std::vector<double>& value, std::vector<double> std,
                                        const std::vector<double>& size) {
  std::vector<double> weight, off;
  for (const double s : size) weight.push_back(s * s);
  const double middle = weighted_median(value, weight);
  for (const double v : value) off.push_back(std::abs(v - middle));
  const double scale = kNormalMad * median(off);
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (off[i] > kOutlier * std::hypot(scale, std[i])) std[i] = std::hypot(std[i], off[i]);
  }
  return std;
}

// Factors of the scatter's variance, at least 1. Near a node the residue is small, and other modes and errors of the
// model move the pole in inverse proportion to it.
std::vector<double> node_factors(const std::vector<double>& size) {
  const double typical = median(size);
  std::vector<double> factor;
  for (const double s : size) factor.push_back(std::max(1.0, std::pow(kNodeSize * typical / s, 2)));
  return factor;
}

}  // namespace

double weighted_median(const std::vector<double>& value, const std::vector<double>& weight) {
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value[a] < value[b]; });
  const double half = 0.5 * std::accumulate(weight.begin(), weight.end(), 0.0);
  double sum = 0;
  for (const std::size_t i : order) {
    sum += weight[i];
    if (sum >= half) return value[i];
  }
  return value.empty() ? 0 : value[order.back()];
}

RobustMean robust_mean(const std::vector<double>& value, const std::vector<double>& stated,
                       const std::vector<double>& size) {
  const std::vector<double> std = widened_at_outliers(value, stated, size), factor = node_factors(size);
  const RandomEffects all = random_effects(value, std, 0, factor);
  return {.value = all.mean, .std = 1 / std::sqrt(all.weights), .spread = std::sqrt(all.variance)};
}

}  // namespace percuss::identify
