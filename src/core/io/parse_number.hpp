#pragma once
#include <cstdint>
#include <string_view>

namespace percuss::inline core {

enum class NumberProblem : std::uint8_t { none, empty, not_a_number, not_finite, too_large };

struct ParsedNumber {
  double value = 0;
  NumberProblem problem = NumberProblem::none;
};

/// A number as instruments write it: blanks and double quotes around it, leading '+', exponent with e, E, d or D,
/// decimal comma if `decimal_comma`. All of `cell` must be the number. Too small a number is 0; texts for infinity and
/// "nan" are not_finite.
ParsedNumber parse_number(std::string_view cell, bool decimal_comma);

/// What is wrong, for people: "empty", "not a number", "not finite", "too large".
std::string_view describe(NumberProblem problem);

/// How many digits stand behind the decimal mark once the exponent is applied: 2 for "0.25", 5 for "1.25e-3", −3 for
/// "4e3".
int decimals_of(std::string_view cell, bool decimal_comma);

/// `text` without blanks at either end; with quotes off as well if it has them on both sides.
std::string_view trimmed(std::string_view text);

}  // namespace percuss::inline core
