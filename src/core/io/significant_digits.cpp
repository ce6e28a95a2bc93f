#include "core/io/significant_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percuss {
inline namespace core {

std::string significant(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return fmt::format("{:g}", value);
  // The exponent is taken after rounding: 9.999 with three digits is 10.0, not 10.00.
  std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  if (exponent < -5) return scientific;
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent));
}

std::string value_with_std(double value, double std) {
  // A standard deviation below the rounding error of the value counts as zero.
  constexpr double kRounding = 1e-14;
  if (!(std > kRounding * std::abs(value)) || !std::isfinite(std)) return fmt::format("{:.6g}", value);
  constexpr double kMinShownStd = 9.95e-12;  // 12 decimals show two digits of larger ones
  if (std < kMinShownStd) return fmt::format("{:.9g} ± {:.1e}", value, std);
  // 0.0996 rounds to 0.10: the decimals follow the rounded standard deviation.
  const double rounded = std::stod(fmt::format("{:.1e}", std));
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(rounded) + 1e-9)), 0, 12);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, std, decimals);
}

}  // namespace core
}  // namespace percuss
