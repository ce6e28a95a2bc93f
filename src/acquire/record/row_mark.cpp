#include "acquire/record/row_mark.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace percuss::acquire {
namespace {

struct MarkText {
  RowMark mark;
  const char *name, *reason;
};

constexpr auto kMarks = std::to_array<MarkText>({
    {RowMark::none, "none", "nothing"},
    {RowMark::double_hit, "double_hit", "two contacts"},
    {RowMark::force_overload, "force_overload", "the force was clipped"},
    {RowMark::response_overload, "response_overload", "a response was clipped"},
    {RowMark::weak, "weak", "too weak"},
    {RowMark::low_bandwidth, "low_bandwidth", "the force did not reach the band's end"},
    {RowMark::silent_channel, "silent_channel", "a channel was silent or dropped out"},
    {RowMark::still_ringing, "still_ringing", "the structure was still ringing"},
    {RowMark::lost_samples, "lost_samples", "samples were lost"},
    {RowMark::outlier, "outlier", "unlike the other blows at the point"},
    {RowMark::no_pulse, "no_pulse", "no clean pulse"},
    {RowMark::undone, "undone", "undone by the operator"},
    {RowMark::redone, "redone", "the operator repeated the point"},
    {RowMark::no_numbers, "no_numbers", "a channel had values that are no numbers"},
    {RowMark::struck_again, "struck_again", "struck again before the decay ended"},
    {RowMark::ended, "ended", "the recording, or its row, ended within the blow"},
});

}  // namespace

std::optional<RowMark> row_mark(double number) {
  const auto* const it = std::find_if(kMarks.begin(), kMarks.end(), [&](const MarkText& text) {
    return static_cast<double>(static_cast<int>(text.mark)) == number;
  });
  return it == kMarks.end() ? std::nullopt : std::optional(it->mark);
}

const char* name_of(RowMark mark) { return kMarks.at(static_cast<std::size_t>(mark)).name; }

std::optional<RowMark> row_mark_named(const std::string& name) {
  const auto* const it =
      std::find_if(kMarks.begin(), kMarks.end(), [&](const MarkText& text) { return text.name == name; });
  return it == kMarks.end() ? std::nullopt : std::optional(it->mark);
}

const char* reason_of(RowMark mark) { return kMarks.at(static_cast<std::size_t>(mark)).reason; }

std::optional<RecordFault> record_fault(std::span<const double, 4> numbers, std::size_t rows) {
  const double fault = numbers[0], row = numbers[1], time_s = numbers[2], value = numbers[3];
  const bool finite = std::isfinite(time_s) && std::isfinite(value);
  const bool known = fault >= 1 && fault <= static_cast<int>(FaultKind::missing_samples) && std::rint(fault) == fault;
  const bool place = row >= -1 && row < static_cast<double>(rows) && std::rint(row) == row;
  if (!finite || !known || !place) return {};
  return RecordFault{.kind = static_cast<FaultKind>(static_cast<int>(fault)),
                     .row = static_cast<int>(row),
                     .time_s = time_s,
                     .value = value};
}

}  // namespace percuss::acquire
