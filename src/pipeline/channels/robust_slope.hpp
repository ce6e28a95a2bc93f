#pragma once
#include <cstddef>
#include <span>

namespace percuss::pipeline {

/// A slope is beyond doubt where the logarithm of its chance is at most kMaxLogChance (one in a million) and the slope
/// exceeds kSureSlope standard deviations.
inline constexpr double kMaxLogChance = -13.8;
inline constexpr double kSureSlope = 5;

/// A line through the origin, fitted to values that scatter by more than their standard deviations.
struct RobustSlope {
  double slope = 0, std = 0;
  double rms = 0;         // of the residuals, weighted as in the fit
  double log_chance = 0;  // natural logarithm of the probability that values without a slope look like these
};

/// The slope b of y ≈ b·x. Values weigh 1/(σ² + s²), with the scatter s of the residuals beyond σ, and far values weigh
/// less. For n values, let e be the rms of the residuals, and e0 their rms for b = 0. The chance is (e/e0)^(n − 1), a
/// bound of the tail of the F test.
/// shapes  x, y, std [n], n ≥ 2
RobustSlope robust_slope(std::span<const double> x, std::span<const double> y, std::span<const double> std);

}  // namespace percuss::pipeline
