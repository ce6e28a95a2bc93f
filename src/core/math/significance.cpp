#include "core/math/significance.hpp"

#include <cmath>
#include <numbers>

namespace percuss {
inline namespace core {

double student_quantile(double z, double degrees) {
  const double p = 0.5 * std::erfc(-z / std::numbers::sqrt2);
  if (degrees <= 1) return std::tan(std::numbers::pi * (p - 0.5));
  if (degrees <= 2) return (2 * p - 1) * std::sqrt(0.5 / (p * (1 - p)));
  const double z2 = z * z;
  const double g1 = z * (z2 + 1) / 4;
  const double g2 = z * (5 * z2 * z2 + 16 * z2 + 3) / 96;
  const double g3 = z * (3 * z2 * z2 * z2 + 19 * z2 * z2 + 17 * z2 - 15) / 384;
  const double g4 = z * (79 * z2 * z2 * z2 * z2 + 776 * z2 * z2 * z2 + 1482 * z2 * z2 - 1920 * z2 - 945) / 92160;
  return z + (g1 + (g2 + (g3 + g4 / degrees) / degrees) / degrees) / degrees;
}

double chi2_deviate(double chi2, double degrees) {
  const double variance = 2 / (9 * degrees);
  return (std::cbrt(chi2 / degrees) - (1 - variance)) / std::sqrt(variance);
}

}  // namespace core
}  // namespace percuss
