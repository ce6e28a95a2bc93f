#include "core/math/random_effects.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace percuss {
inline namespace core {
namespace {

struct WeightedMean {
  double mean = 0, weights = 0, squares = 0;  // Σw and Σw²
};

}  // namespace

RandomEffects random_effects(const std::vector<double>& value, const std::vector<double>& std, double origin,
                             const std::vector<double>& factor) {
  const auto weighted = [&](double variance) {
    WeightedMean out;
    double sum = 0;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const double w = 1 / (std[i] * std[i] + variance * (factor.empty() ? 1 : factor[i]));
      sum += w * (value[i] - origin);
      out.weights += w;
      out.squares += w * w;
    }
    out.mean = origin + sum / out.weights;
    return out;
  };
  const WeightedMean own = weighted(0);
  RandomEffects out{.own_weights = own.weights};
  for (std::size_t i = 0; i < value.size(); ++i) out.chi2 += std::pow((value[i] - own.mean) / std[i], 2);
  const double excess = out.chi2 - static_cast<double>(value.size() - 1);
  out.variance = std::max(0.0, excess / (own.weights - own.squares / own.weights));  // (4.15)
  const WeightedMean both = weighted(out.variance);
  out.mean = both.mean;
  out.weights = both.weights;
  return out;
}

}  // namespace core
}  // namespace percuss
