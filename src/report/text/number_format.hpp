#pragma once
#include <string>

namespace percuss::report {

/// "169.00034 ± 0.00042": the standard deviation with two significant digits, the value with as many decimals. For a
/// standard deviation of 0 or NaN: the value alone, with six significant digits. At most 12 decimals; a smaller
/// standard deviation has an exponent.
std::string value_with_std(double value, double std);

/// Frequencies: four significant digits, k for thousands ("3.9 kHz").
std::string rounded_frequency_text(double freq_Hz);

/// A frequency as a number of hertz: four significant digits, whole hertz from 10 kHz, no exponent below 1 MHz.
std::string hertz_text(double freq_Hz);

/// "232 N", "1750 N": three significant digits, no exponent from 0.0001 N to 1 GN.
std::string force_text(double force_N);

}  // namespace percuss::report
