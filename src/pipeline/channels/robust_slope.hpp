#pragma once
#include <cstddef>
#include <span>

namespace percuss::pipeline {

/// A slope is beyond doubt from this logarithm of its chance down (one in a million), and from this many standard
/// deviations up.
inline constexpr double kMaxLogChance = -13.8;
inline constexpr double kSureSlope = 5;

/// A line through the origin, fitted to values that scatter by more than their standard deviations.
struct RobustSlope {
  double slope = 0, std = 0;
  double rms = 0;         // of the residuals, weighted as in the fit
  double log_chance = 0;  // natural logarithm of the probability that values without a slope look like these
};

/// The slope b of y ≈ b·x. Values weigh 1/(σ² + s²), with the scatter s of the residuals beyond σ, and far values weigh
/// less. With n values and the residuals' rms e, which is e0 for b = 0, the chance is (e/e0)^(n − 1), the tail of the
/// F test.
/// shapes  x, y, std [n], n ≥ 2
RobustSlope robust_slope(std::span<const double> x, std::span<const double> y, std::span<const double> std);

}  // namespace percuss::pipeline
