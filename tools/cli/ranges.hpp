#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option_error.hpp"
#include "core/error.hpp"

namespace percuss::tools {

/// Equally spaced values, written LO:STEP:HI.
struct Range {
  double low = 0, step = 1;
  std::size_t count = 0;

  double at(std::size_t i) const { return low + static_cast<double>(i) * step; }
  double high() const { return at(count - 1); }
  std::vector<double> values() const;
};

struct RangeText {
  Range range;
  std::string_view unit;  // the text after the numbers
};

enum class RangeForm { several_values, single_value_allowed };

/// Reads "3:0.25:9in" for the option `option` ("positions"). Throws an OptionError that ends in `remedy` unless the
/// text holds three finite numbers, the step is above zero, HI is above LO (or equal, where `form` allows a single
/// value), HI is a whole number of steps from LO, and there are at most 10000 values.
RangeText parse_range_with_unit(const OptionId& option, const std::string& text, const char* remedy,
                                RangeForm form = RangeForm::several_values);

/// Reads a range. With `placeholder` (M, M/S), a unit of in_option_unit may follow, which holds for all three numbers:
/// "3:0.25:9in"; the result is in the unit of the placeholder. Otherwise the range has no unit.
Range parse_range(const OptionId& option, const std::string& text, RangeForm form = RangeForm::several_values,
                  std::string_view placeholder = {});

}  // namespace percuss::tools
