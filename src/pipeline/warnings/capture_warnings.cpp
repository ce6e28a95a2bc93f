#include "pipeline/warnings/capture_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percuss::pipeline {
namespace {

using acquire::FaultKind, acquire::RecordFault;

// Beyond this the frequencies are wrong by more than a good test's ±.
constexpr double kLargeDrift = 1e-4;

const char* end_text(FaultKind fault) {
  if (fault == FaultKind::unplugged) return "the device was unplugged";
  return fault == FaultKind::rate_changed ? "the device changed its sampling rate" : "the device stopped";
}

void add_losses(const acquire::Record& record, std::vector<Warning>& out) {
  std::size_t losses = 0, in_blows = 0;
  double first_s = 0, frames = 0;
  for (const RecordFault& finding : record.faults) {
    if (finding.kind > FaultKind::not_a_number) continue;
    if (losses++ == 0) first_s = finding.time_s;
    frames += finding.value;
    if (finding.row >= 0) ++in_blows;
  }
  if (losses == 0) return;
  std::string text = fmt::format("the capture lost {:.0f} samples per channel in {} place{}, first at {:.1f} s", frames,
                                 losses, losses == 1 ? "" : "s", first_s);
  if (in_blows > 0) text += fmt::format("; {} of them in a blow, which was rejected", in_blows);
  out.push_back(with_remedy({"capture_lost_samples", text},
                            "close other programs, use another USB socket, or record fewer channels"));
}

}  // namespace

std::vector<Warning> capture_warnings(const acquire::Record& record) {
  std::vector<Warning> out;
  add_losses(record, out);
  for (const RecordFault& finding : record.faults) {
    if (finding.kind == FaultKind::clock_drift && std::abs(finding.value) > kLargeDrift) {
      out.push_back(with_remedy(
          {"capture_clock", fmt::format("the device's clock differs by {:.0f} ppm from the computer's, and so may all "
                                        "frequencies",
                                        finding.value * 1e6)},
          "state the true sampling rate"));
      out.back().options = {"fs"};
    }
    if (finding.kind >= FaultKind::unplugged && finding.kind <= FaultKind::failed)
      out.push_back({"capture_ended", fmt::format("{} after {:.1f} s", end_text(finding.kind), finding.time_s)});
  }
  return out;
}

}  // namespace percuss::pipeline
