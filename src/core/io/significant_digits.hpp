#pragma once
#include <string>

namespace percuss {
inline namespace core {

/// `value` with `digits` significant digits, never rounded to zero. Examples with 3: 12.0, 0.0432, 1520 and 1.20e-07.
std::string significant(double value, int digits);

}  // namespace core
}  // namespace percuss
