#pragma once

namespace percuss {
inline namespace core {

/// Quantile of Student's t distribution, for a probability above 0.5 given as the normal quantile `z` of the same
/// probability. Exact for one and two degrees of freedom; otherwise the Cornish–Fisher expansion, within 1 % for
/// |z| < 2.6, and within 2.3 % for |z| < 3.
double student_quantile(double z, double degrees);

/// χ² as the normal deviate of the same probability, by the cube root of Wilson and Hilferty.
double chi2_deviate(double chi2, double degrees);

}  // namespace core
}  // namespace percuss
