#pragma once
#include <cstddef>
#include <string>

#include "core/io/significant_digits.hpp"

namespace percuss::report {

using core::value_with_std;

/// "3 rows", "1 row".
std::string counted(std::size_t count, const std::string& noun);

/// Frequencies: four significant digits, k for thousands ("3.9 kHz").
std::string rounded_frequency_text(double freq_Hz);

/// A frequency as a number of hertz: four significant digits, whole hertz from 10 kHz, no exponent below 1 MHz.
std::string hertz_text(double freq_Hz);

/// "232 N", "1750 N": three significant digits, no exponent from 0.0001 N to 1 GN.
std::string force_text(double force_N);

}  // namespace percuss::report
