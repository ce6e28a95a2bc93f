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

}  // namespace core
}  // namespace percuss
