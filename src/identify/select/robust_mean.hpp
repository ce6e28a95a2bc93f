#pragma once
#include <vector>

namespace percuss::identify {

/// The standard deviation of a normal distribution over its median absolute deviation.
inline constexpr double kNormalMad = 1.4826;

/// The value below which half of the weight lies; 0 for no values.
double weighted_median(const std::vector<double>& value, const std::vector<double>& weight);

/// A mean, its standard deviation, and the spread of the values beyond their standard deviations.
struct RobustMean {
  double value = 0, std = 0, spread = 0;
};

/// The mean of values that scatter more than their standard deviations `stated` (random effects, method of moments).
/// `size`: magnitude of the residue behind each value. Outliers lose weight, and so do values with a small `size`, for
/// instance near a node.
/// theory (4.15)
RobustMean robust_mean(const std::vector<double>& value, const std::vector<double>& stated,
                       const std::vector<double>& size);

}  // namespace percuss::identify
