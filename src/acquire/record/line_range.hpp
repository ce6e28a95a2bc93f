#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::acquire {

/// The largest distance of an FRF's frequency from a multiple of the spacing, relative to the spacing. It applies if no
/// rounding of the digits explains the distance.
inline constexpr double kMaxLineOffset = 0.05;
/// The largest number of lines of an FRF from 0 Hz on, present or not.
inline constexpr std::size_t kMaxFrfLines = std::size_t{1} << 28U;

/// Spectral lines first … first + count − 1 of the transform of `samples` values.
struct LineRange {
  double fs_Hz = 0;
  std::size_t samples = 0;
  std::size_t first = 0;
  std::size_t count = 0;
  double df_Hz() const { return fs_Hz / static_cast<double>(samples); }
  double freq_Hz(std::size_t line) const { return static_cast<double>(first + line) * df_Hz(); }
  double position(double freq_Hz) const { return freq_Hz / df_Hz() - static_cast<double>(first); }  // in lines
  std::size_t nearest(double freq_Hz) const { return at(position(freq_Hz)); }
  /// The line nearest to a position; the first or last one for a position beyond them.
  std::size_t at(double position) const {
    return static_cast<std::size_t>(std::clamp(std::round(position), 0.0, static_cast<double>(count - 1)));
  }
};

/// [count] the frequency of each line.
std::vector<double> frequencies_Hz(const LineRange& lines);

/// The lines of frequency_lines() for frequencies in Hz.
/// errors  As frequency_lines().
LineRange lines_from_frequencies(const std::vector<double>& freq_Hz, const std::string& where);

}  // namespace percuss::acquire
