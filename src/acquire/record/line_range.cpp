#include "acquire/record/line_range.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace percuss::acquire {

LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where) {
  const char* const remedy = "save one line per frequency, evenly spaced from 0 Hz or a multiple of the spacing";
  const std::size_t n = freq_Hz.size();
  if (n < 2) throw InputError("fewer than two frequencies", where, remedy);
  const double rough_Hz = (freq_Hz.back() - freq_Hz.front()) / static_cast<double>(n - 1);
  if (!(freq_Hz.front() >= 0) || !(rough_Hz > 0))
    throw InputError("frequencies that are negative, or do not rise", where, remedy);
  const double first = std::round(freq_Hz.front() / rough_Hz);
  if (!(first < static_cast<double>(kMaxFrfLines)))
    throw InputError("frequencies too close together (more than 2^28 lines from 0 Hz)", where, remedy);
  const double df_Hz = freq_Hz.back() / (first + static_cast<double>(n - 1));
  for (std::size_t k = 0; k < n; ++k) {
    const double expected_Hz = (first + static_cast<double>(k)) * df_Hz;
    if (std::abs(freq_Hz[k] - expected_Hz) <= kMaxLineOffset * df_Hz) continue;
    throw InputError(
        fmt::format("the frequency {:.8g} Hz is not a multiple of the spacing of {:.6g} Hz", freq_Hz[k], rough_Hz),
        where, remedy);
  }
  LineRange lines{.first = static_cast<std::size_t>(first), .count = n};
  lines.samples = 2 * (lines.first + n - 1);
  lines.fs_Hz = df_Hz * static_cast<double>(lines.samples);
  return lines;
}

}  // namespace percuss::acquire
