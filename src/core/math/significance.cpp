#include "core/math/significance.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace percuss {
inline namespace core {

double student_quantile(double z, double degrees) {
  const double above = 0.5 * std::erfc(std::abs(z) / std::numbers::sqrt2);
  return std::copysign(gsl_cdf_tdist_Qinv(above, std::max(degrees, 1.0)), z);
}

double student_factor(double degrees) {
  constexpr double kDeviateOf95Percent = 1.96;  // of the normal distribution
  return student_quantile(kDeviateOf95Percent, degrees) / kDeviateOf95Percent;
}

double upper_tail(double deviate) { return 0.5 * std::erfc(deviate / std::numbers::sqrt2); }

double chance_of_count(std::size_t count, std::size_t tests, double p_value) {
  return gsl_cdf_binomial_Q(static_cast<unsigned>(count - 1), p_value, static_cast<unsigned>(tests));
}

double chi2_deviate(double chi2, double degrees) {
  const double variance = 2 / (9 * degrees);
  return (std::cbrt(chi2 / degrees) - (1 - variance)) / std::sqrt(variance);
}

double birge_ratio(double chi2, double degrees) {
  return degrees > 0 && chi2_deviate(chi2, degrees) > kOnceIn1000 ? std::sqrt(chi2 / degrees) : 1;
}

}  // namespace core
}  // namespace percuss
