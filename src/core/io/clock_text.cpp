#include "core/io/clock_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

// Removes the digits at the front and returns their value. Nothing without a digit or with more than `most` digits.
std::optional<double> take_digits(std::string_view& text, std::size_t most, int& count) {
  double value = 0;
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[digits])) {
    if (digits == most) return std::nullopt;
    value = 10 * value + (text[digits] - '0');
    ++digits;
  }
  if (digits == 0) return std::nullopt;
  text.remove_prefix(digits);
  count = static_cast<int>(digits);
  return value;
}

bool take(std::string_view& text, std::string_view any) {
  if (text.empty() || any.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// A date holds digits and marks only; 'T' or blanks follow it.
bool is_date(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == 'T')) text.remove_suffix(1);
  const bool marked = text.find_first_of("-/.") != std::string_view::npos;
  return marked && is_digit(text.front()) && text.find_first_not_of("0123456789-/.") == std::string_view::npos;
}

bool is_zone(std::string_view text) {
  text = trimmed(text);
  if (text.empty() || text == "Z" || text == "UTC") return true;
  const bool offset = text.front() == '+' || text.front() == '-';
  return offset && text.size() <= 6 && text.find_first_not_of("0123456789:", 1) == std::string_view::npos;
}

}  // namespace

std::optional<ClockTime> parse_clock(std::string_view cell) {
  constexpr std::size_t kMaxFraction = 15;
  constexpr double kHour_s = 3600, kMinute_s = 60;
  std::string_view rest = trimmed(cell);
  const std::size_t colon = rest.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::size_t start = colon;
  while (start > 0 && is_digit(rest[start - 1])) --start;
  if (start > 0 && !is_date(rest.substr(0, start))) return std::nullopt;
  rest.remove_prefix(start);
  int digits = 0;
  ClockTime clock;
  const auto hour = take_digits(rest, 2, digits);
  const bool first = take(rest, ":");
  const auto minute = take_digits(rest, 2, digits);
  const bool second_mark = take(rest, ":");
  const auto second = take_digits(rest, 2, digits);
  if (!hour || !first || !minute || !second_mark || !second || *hour > 24 || *minute > 59 || *second > 60)
    return std::nullopt;
  double fraction_s = 0;
  if (take(rest, ".,")) {
    const auto fraction = take_digits(rest, kMaxFraction, clock.decimals);
    if (!fraction) return std::nullopt;
    fraction_s = *fraction * std::pow(10.0, -clock.decimals);
  }
  double hours = *hour;
  std::string_view after = trimmed(rest);
  if (after == "AM" || after == "PM" || after == "am" || after == "pm") {
    hours = std::fmod(hours, 12) + (after.front() == 'P' || after.front() == 'p' ? 12 : 0);
  } else if (!is_zone(after)) {
    return std::nullopt;
  }
  clock.time_s = hours * kHour_s + *minute * kMinute_s + *second + fraction_s;
  return clock;
}

}  // namespace core
}  // namespace percuss
