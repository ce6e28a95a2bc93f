#pragma once
#include <string>

namespace percuss::inline core {

/// `value` with this many significant digits, never rounded to zero: 12.0, 0.0432, 1520 and 1.20e-07 with 3.
std::string significant(double value, int digits);

}  // namespace percuss::inline core
