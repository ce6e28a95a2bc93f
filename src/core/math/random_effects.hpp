#pragma once
#include <vector>

namespace percuss {
inline namespace core {

/// The mean of values that may scatter beyond their standard deviations (random effects, method of moments; [20] in
/// docs/theory/sources.md).
struct RandomEffects {
  double mean = 0;         // weighted by the values' own variances and the variance between them
  double weights = 0;      // sum of these weights: the inverse variance of the mean
  double own_weights = 0;  // the same of a mean weighted by the values' own variances alone
  double chi2 = 0;         // about that mean
  double variance = 0;     // between the values, beyond their own
};

/// `origin`: a number near the values keeps the rounding errors of the mean small. `factor`: the variance between the
/// values is multiplied by it; empty means 1.
/// shapes  value, std and factor equal, at least one value; std above 0
/// theory (4.15)
RandomEffects random_effects(const std::vector<double>& value, const std::vector<double>& std, double origin,
                             const std::vector<double>& factor = {});

}  // namespace core
}  // namespace percuss
