#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace percuss::acquire {

/// A fault of the capture. None is repaired silently; all are stored in the journal.
enum class CaptureFault {
  gap,             // the device states how many frames it lost
  overrun,         // a buffer of the device overflowed; `count` is 0 where the lost frames are not known
  dropped,         // the ring buffer was full: percuss lost frames
  not_in_journal,  // frames are not in the journal: the disk was full, or memory held them no longer
  journal_failed,  // the journal cannot be written at present; `text` says why
  clock_drift,     // the device's rate differs from the stated one; `value` is the relative difference
  not_a_number,    // samples of a channel are NaN or infinite
  overload,        // samples of a channel reach the full scale
  unplugged,
  rate_changed,
  failed,
  resumed,  // the session was continued after an interruption
};

struct CaptureFinding {
  CaptureFault fault = CaptureFault::gap;
  std::uint64_t frame = 0;               // the first frame concerned, or the first after a loss
  std::uint64_t count = 0;               // lost frames or faulty samples; 0: not known
  std::optional<std::size_t> channel{};  // from 0
  double value = 0;
  std::string text{};

  bool operator==(const CaptureFinding&) const = default;
};

/// "gap", "overrun", … as the journal's JSON names it.
const char* fault_name(CaptureFault fault);
/// A sentence for people, without the place: "the device lost 200 frames".
std::string finding_text(const CaptureFinding& finding);

/// One line of JSON.
std::string finding_json(const CaptureFinding& finding);
/// errors  InputError at `where`: not such a text
CaptureFinding parse_finding(const std::string& json, const std::string& where);

}  // namespace percuss::acquire
