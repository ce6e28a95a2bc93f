#pragma once
#include <optional>
#include <string_view>

namespace percuss {
inline namespace core {

/// A time of day in a text: "2024-05-06T07:08:09.000244Z", "06.05.2024 07:08:09,5", "7:08:09.5 PM".
struct ClockTime {
  double time_s = 0;  // since midnight
  int decimals = 0;   // written digits of the second's fraction
};

/// The time of day in `cell`: hours, minutes, seconds with a fraction after a point or comma, then AM or PM. A date
/// before it and a time zone after it are allowed and not read. Nothing for other texts.
std::optional<ClockTime> parse_clock(std::string_view cell);

}  // namespace core
}  // namespace percuss
