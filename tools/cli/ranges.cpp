#include "cli/ranges.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "cli/option_error.hpp"
#include "cli/option_units.hpp"
#include "core/error.hpp"
#include "core/io/parse_number.hpp"

namespace percuss::tools {
namespace {

constexpr double kMaxValues = 10000;
constexpr double kWholeSteps = 1e-6;  // of a step: the largest distance of HI from a whole number of steps
constexpr const char* kForm = "give LO:STEP:HI, such as 100:25:10000";

}  // namespace

std::vector<double> Range::values() const {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = at(i);
  return all;
}

RangeText parse_range_with_unit(const OptionId& option, const std::string& text, const char* remedy, RangeForm form) {
  const auto refuse = [&](const char* problem) { return OptionError::wrong_value(option, text, remedy, problem); };
  std::array<double, 3> number{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ':')) throw refuse("it is not three numbers separated by colons");
    if (end - at > 1 && at[0] == '+' && at[1] != '-') ++at;  // std::from_chars takes no plus sign
    const auto [after, error] = std::from_chars(at, end, number.at(i));
    if (error != std::errc{} || !std::isfinite(number.at(i)))
      throw refuse("it is not three numbers separated by colons");
    at = after;
  }
  const auto [low, step, high] = number;
  const bool spans = high > low || (form == RangeForm::single_value_allowed && high == low);
  if (!(step > 0) || !spans) throw refuse("the step must be above zero and the end above the start");
  const double steps = (high - low) / step;
  if (!(steps < kMaxValues)) throw refuse("more than 10000 values");
  if (std::abs(steps - std::round(steps)) > kWholeSteps)
    throw refuse("the end is not a whole number of steps from the start");
  return {.range = {.low = low, .step = step, .count = static_cast<std::size_t>(std::lround(steps)) + 1},
          .unit = {at, static_cast<std::size_t>(end - at)}};
}

Range parse_range(const OptionId& option, const std::string& text, RangeForm form, std::string_view placeholder) {
  auto [range, unit] = parse_range_with_unit(option, text, kForm, form);
  if (unit.empty()) return range;
  // The conversion factor: the number 1 with the typed unit, in the placeholder's unit.
  const std::string one = "1" + std::string(unit), converted = in_option_unit(one, placeholder);
  const ParsedNumber factor = parse_number(converted, false);
  if (converted == one || factor.problem != NumberProblem::none)
    throw OptionError::wrong_value(option, text, kForm, "something follows the numbers");
  range.low *= factor.value;
  range.step *= factor.value;
  return range;
}

}  // namespace percuss::tools
