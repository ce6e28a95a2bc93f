#pragma once
#include <string>

namespace percuss {
inline namespace core {

/// `value` with `digits` significant digits, and with all digits before the decimal point; never rounded to zero.
/// Examples with 3: 12.0, 0.0432, 1523 and 1.20e-07.
std::string significant(double value, int digits);

/// "169.00034 ± 0.00042": the standard deviation with two significant digits, the value with as many decimals. For a
/// standard deviation of 0 or NaN: the value alone, with six significant digits. At most 12 decimals; a smaller
/// standard deviation has an exponent.
std::string value_with_std(double value, double std);

}  // namespace core
}  // namespace percuss
