#pragma once
#include <cstddef>

namespace percuss {
inline namespace core {

/// Normal deviates that chance exceeds once in 1000 cases, and once in 300 000.
inline constexpr double kOnceIn1000 = 3.1, kOnceIn300000 = 4.5;

/// Quantile of Student's t distribution for the probability of the normal quantile `z`. `degrees` of freedom below 1
/// count as 1.
double student_quantile(double z, double degrees);

/// The 97.5 % quantile of Student's t for these degrees of freedom, over 1.96. A standard deviation estimated from few
/// values is multiplied by it, so that ±1.96 standard deviations still cover 95 %.
double student_factor(double degrees);

/// The probability that a normal deviate exceeds `deviate`.
double upper_tail(double deviate);

/// The probability that at least `count` of `tests` independent tests fall below `p_value` by chance. Several tests can
/// be significant together although each alone is not. count: 1 to `tests`; p_value: 0 to 1.
double chance_of_count(std::size_t count, std::size_t tests, double p_value);

/// χ² as the normal deviate of the same probability, by the cube root of Wilson and Hilferty.
double chi2_deviate(double chi2, double degrees);

/// The factor by which a misfit enlarges the standard deviations of a fit: the root of χ² per degree of freedom
/// (Birge's ratio), if χ² is larger than chance makes it once in 1000 cases; otherwise 1. 1 without degrees of freedom.
double birge_ratio(double chi2, double degrees);

}  // namespace core
}  // namespace percuss
