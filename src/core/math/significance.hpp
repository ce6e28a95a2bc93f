#pragma once

namespace percuss {
inline namespace core {

/// Normal deviates that chance exceeds once in 1000 cases, and once in 300 000.
inline constexpr double kOnceIn1000 = 3.1, kOnceIn300000 = 4.5;

/// Quantile of Student's t distribution for the probability of the normal quantile `z`. `degrees` of freedom below 1
/// count as 1.
double student_quantile(double z, double degrees);

/// χ² as the normal deviate of the same probability, by the cube root of Wilson and Hilferty.
double chi2_deviate(double chi2, double degrees);

}  // namespace core
}  // namespace percuss
