#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace percuss::acquire {

/// Why a blow was rejected while it was recorded. Files store the number: add values at the end, change none.
enum class RowMark {
  none = 0,
  double_hit = 1,
  force_overload = 2,
  response_overload = 3,
  weak = 4,
  low_bandwidth = 5,
  silent_channel = 6,
  still_ringing = 7,
  lost_samples = 8,
  outlier = 9,
  no_pulse = 10,
  undone = 11,  // alone, as the latest accepted blow
  redone = 12,  // undone with its point, whose blows are repeated
  no_numbers = 13,
  struck_again = 14,
  ended = 15
};

/// The mark with this number; nothing for an unknown one.
std::optional<RowMark> row_mark(double number);
/// For programs: "double_hit".
const char* name_of(RowMark mark);
/// The mark with this name; nothing for an unknown one.
std::optional<RowMark> row_mark_named(const std::string& name);
/// For people, as the end of a sentence: "two contacts".
const char* reason_of(RowMark mark);

/// A fault while a record was captured. Files store the number, as for RowMark.
enum class FaultKind {
  gap = 1,              // `value` frames are missing
  overrun = 2,          // the device lost samples; `value` frames, 0: not known
  dropped = 3,          // the computer was too slow; `value` frames
  not_a_number = 4,     // `value` samples were NaN or infinite
  clock_drift = 5,      // the device's rate differs from the stated one by `value`, relative
  unplugged = 6,        // the device disappeared
  rate_changed = 7,     // the device changed its sampling rate
  failed = 8,           // the device stopped for another reason
  resumed = 9,          // the session was continued after an interruption
  missing_samples = 10  // the row lacks `value` samples, and a straight line takes their place: see SampleGap
};

struct RecordFault {
  FaultKind kind = FaultKind::gap;
  int row = -1;       // whose samples are concerned; −1: between the rows
  double time_s = 0;  // since the start of the capture; for missing_samples, since the start of the row
  double value = 0;
  bool operator==(const RecordFault&) const = default;
};

/// The fault with these numbers, [fault, row, time, value] as files store it; nothing for an unknown fault, a row
/// that does not exist, or a number that is not finite.
std::optional<RecordFault> record_fault(std::span<const double, 4> numbers, std::size_t rows);

}  // namespace percuss::acquire
