#include "report/text/number_format.hpp"

#include <fmt/format.h>

#include <cmath>

namespace percuss::report {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
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
