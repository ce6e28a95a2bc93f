#pragma once
#include <string>
#include <vector>

#include "acquire/record/line_range.hpp"

namespace percuss::acquire {

/// The spacings in Hz that explain every frequency of a file within its rounding.
struct SpacingLimits {
  double lowest_Hz = 0, highest_Hz = 0;
};

/// The spectral lines of a file's frequencies.
struct FrequencyLines {
  LineRange lines;
  SpacingLimits spacing;
  std::string note;  // says that the frequencies are rounded; empty where the spacing is not in doubt by 1e-7
};

/// The lines of evenly spaced frequencies that are multiples of their spacing: numbers[k]·to_Hz = (first + k)·df.
/// Frequencies may be rounded to a number of decimals, to significant digits or to single precision. Of the spacings
/// that explain each of them, df is the roundest: it, its inverse (the length of the record), the last frequency or a
/// sampling rate df·2^p has the fewest digits. Without a round one, df is the middle of the limits. Numbers that no
/// rounding explains may lie kMaxLineOffset off their lines.
/// numbers  [lines], in the unit of the file
/// to_Hz    Hz per unit
/// errors  InputError at `where`: fewer than two, uneven, falling, negative, not finite.
FrequencyLines frequency_lines(const std::vector<double>& numbers, double to_Hz, const std::string& where);

}  // namespace percuss::acquire
