#pragma once
#include <cstdint>
#include <string_view>

namespace percuss {
inline namespace core {

enum class NumberProblem : std::uint8_t { none, empty, not_a_number, not_finite, too_large };

struct ParsedNumber {
  double value = 0;
  NumberProblem problem = NumberProblem::none;
};

/// A decimal digit, whatever the locale.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Parses a number as instruments write it: surrounding blanks and double quotes, leading '+', exponent with e, E, d or
/// D, decimal comma if `decimal_comma`. The number must fill `cell`. A number too small for double is 0; "inf",
/// "nan" and the error texts of programs ("#N/A", "1.#IND") are not_finite.
ParsedNumber parse_number(std::string_view cell, bool decimal_comma);

/// The text for messages: "empty", "not a number", "not finite", "too large".
std::string_view describe(NumberProblem problem);

/// The number of digits after the decimal mark with the exponent applied: 2 for "0.25", 5 for "1.25e-3", −3 for "4e3".
int decimals_of(std::string_view cell, bool decimal_comma);

/// `text` without blanks at both ends, and without quotes if both ends have them.
std::string_view trimmed(std::string_view text);

}  // namespace core
}  // namespace percuss
