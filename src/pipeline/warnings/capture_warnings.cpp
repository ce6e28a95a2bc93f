#include "pipeline/warnings/capture_warnings.hpp"

#include <fmt/format.h>

#include "core/io/counted_words.hpp"

namespace percuss::pipeline {
namespace {

using acquire::FaultKind, acquire::RecordFault;

const char* end_text(FaultKind fault) {
  if (fault == FaultKind::unplugged) return "the device was unplugged";
  return fault == FaultKind::rate_changed ? "the device changed its sampling rate" : "the device stopped";
}

void add_losses(const acquire::Record& record, std::vector<Warning>& out) {
  std::size_t losses = 0, unknown = 0, in_blows = 0, no_numbers = 0;
  double first_s = 0, frames = 0, samples = 0, first_no_number_s = 0;
  for (const RecordFault& fault : record.faults) {
    if (fault.kind > FaultKind::not_a_number) continue;
    if (fault.row >= 0) ++in_blows;
    if (fault.kind == FaultKind::not_a_number) {
      if (no_numbers++ == 0) first_no_number_s = fault.time_s;
      samples += fault.value;
      continue;
    }
    if (losses++ == 0) first_s = fault.time_s;
    if (fault.value == 0) ++unknown;
    frames += fault.value;
  }
  std::string text;
  if (losses > 0) {
    const std::string count = frames > 0
                                  ? fmt::format("{}{:.0f} samples per channel", unknown > 0 ? "at least " : "", frames)
                                  : "an unknown number of samples";
    text = fmt::format("the capture lost {} in {} place{}, first at {:.1f} s", count, losses, plural(losses), first_s);
  }
  if (no_numbers > 0) {
    text += fmt::format("{}{:.0f} captured samples are no numbers, in {} place{}, first at {:.1f} s",
                        text.empty() ? "" : "; ", samples, no_numbers, plural(no_numbers), first_no_number_s);
  }
  if (text.empty()) return;
  if (in_blows > 0)
    text += fmt::format("; {} of them in {}", in_blows,
                        in_blows == 1 ? "a blow, which was rejected" : "blows, which were rejected");
  std::string remedy = losses > 0 ? "close other programs, use another USB socket, or record fewer channels" : "";
  if (no_numbers > 0) remedy += (remedy.empty() ? "" : "; ") + std::string("check the cable and input of each channel");
  out.push_back(with_remedy({"capture_lost_samples", text}, remedy));
}

}  // namespace

std::vector<Warning> capture_warnings(const acquire::Record& record) {
  std::vector<Warning> out;
  add_losses(record, out);
  for (const RecordFault& fault : record.faults) {
    // A capture states a drift only beyond 200 ppm and five standard deviations: see sample_store.cpp.
    if (fault.kind == FaultKind::clock_drift) {
      out.push_back(with_remedy({"capture_clock",
                                 fmt::format("the device's clock differs by {:.0f} ppm from the computer's, and so may "
                                             "all frequencies",
                                             fault.value * 1e6),
                                 {"fs"}},
                                "state the true sampling rate"));
    }
    if (fault.kind >= FaultKind::unplugged && fault.kind <= FaultKind::failed)
      out.push_back({"capture_ended", fmt::format("{} after {:.1f} s", end_text(fault.kind), fault.time_s)});
  }
  return out;
}

}  // namespace percuss::pipeline
