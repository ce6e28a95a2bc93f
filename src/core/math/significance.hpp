#pragma once

namespace percuss {
inline namespace core {

/// Quantile of Student's t distribution for the probability of the normal quantile `z`. `degrees` of freedom below 1
/// count as 1.
double student_quantile(double z, double degrees);

/// χ² as the normal deviate of the same probability, by the cube root of Wilson and Hilferty.
double chi2_deviate(double chi2, double degrees);

}  // namespace core
}  // namespace percuss
