#include "report/text/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percuss::report {

std::string value_with_std(double value, double deviation) {
  // A deviation below the rounding error of the value counts as zero.
  constexpr double kRounding = 1e-14;
  if (!(deviation > kRounding * std::abs(value)) || !std::isfinite(deviation)) return fmt::format("{:.6g}", value);
  constexpr double kSmallest = 9.95e-12;  // 12 decimals show two digits of larger deviations
  if (deviation < kSmallest) return fmt::format("{:.9g} ± {:.1e}", value, deviation);
  // 0.0996 rounds to 0.10: the decimals follow the rounded deviation.
  const double rounded = std::stod(fmt::format("{:.1e}", deviation));
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(rounded) + 1e-9)), 0, 12);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, deviation, decimals);
}

std::string hertz_text(double freq_Hz) {
  constexpr double kFiveDigits = 9999.5, kMaxDigits = 1e6;
  return freq_Hz >= kFiveDigits && freq_Hz < kMaxDigits ? fmt::format("{:.0f}", freq_Hz)
                                                        : fmt::format("{:.4g}", freq_Hz);
}

std::string rounded_frequency_text(double freq_Hz) {
  return freq_Hz >= 1000 ? fmt::format("{:.4g} kHz", freq_Hz / 1000) : fmt::format("{:.4g} Hz", freq_Hz);
}

std::string force_text(double force_N) {
  constexpr double kThreeDigits = 999.5, kMaxDigits = 1e9;
  const double size = std::abs(force_N);
  if (!(size >= kThreeDigits && size < kMaxDigits)) return fmt::format("{:.3g} N", force_N);
  const double unit = std::pow(10, std::floor(std::log10(size)) - 2);
  return fmt::format("{:.0f} N", std::round(force_N / unit) * unit);
}

}  // namespace percuss::report
