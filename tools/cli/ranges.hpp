#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

/// Values an equal step apart, as the command line writes them: LO:STEP:HI.
struct Range {
  double low = 0, step = 1;
  std::size_t count = 0;

  double at(std::size_t i) const { return low + static_cast<double>(i) * step; }
  double high() const { return at(count - 1); }
  std::vector<double> values() const;
};

struct RangeText {
  Range range;
  std::string_view unit;  // what follows the numbers, a part of the text
};

/// What a range may come to.
enum class RangeForm { several_values, single_value_allowed };

/// Reads "3:0.25:9in". `option` names the place for the message ("--positions"), `remedy` is its end. UsageError unless
/// three finite numbers stand there, the step is above zero, HI above LO (or where it may be one value, equal), HI
/// reached in whole steps, and there are at most 10000.
RangeText parse_range_with_unit(const std::string& option, const std::string& text, const char* remedy,
                                RangeForm may = RangeForm::several_values);

/// The same with nothing after the numbers.
Range parse_range(const std::string& option, const std::string& text, RangeForm may = RangeForm::several_values);

}  // namespace percuss::tools
