#include "pipeline/live/session_faults.hpp"

#include <algorithm>
#include <utility>

namespace percuss::pipeline {
namespace {

using acquire::CaptureFault, acquire::CaptureFinding, acquire::FaultKind;

constexpr std::size_t kMaxFaults = 100'000;
constexpr double kOneFault_s = 1;  // unusable samples (NaN, infinite) that are closer together count as one fault

bool is_loss(CaptureFault fault) {
  return fault == CaptureFault::gap || fault == CaptureFault::overrun || fault == CaptureFault::dropped ||
         fault == CaptureFault::not_a_number || fault == CaptureFault::resumed;
}

// The kind under which a record stores a fault. Overloads are not stored, because the grading of the hits finds them;
// faults of the journal are not, because a complete record no longer needs the journal.
std::optional<FaultKind> stored_kind(CaptureFault fault) {
  switch (fault) {
    case CaptureFault::gap:
      return FaultKind::gap;
    case CaptureFault::overrun:
      return FaultKind::overrun;
    case CaptureFault::dropped:
      return FaultKind::dropped;
    case CaptureFault::not_a_number:
      return FaultKind::not_a_number;
    case CaptureFault::clock_drift:
      return FaultKind::clock_drift;
    case CaptureFault::unplugged:
      return FaultKind::unplugged;
    case CaptureFault::rate_changed:
      return FaultKind::rate_changed;
    case CaptureFault::failed:
      return FaultKind::failed;
    case CaptureFault::resumed:
      return FaultKind::resumed;
    case CaptureFault::overload:
    case CaptureFault::not_in_journal:
    case CaptureFault::journal_failed:
      break;
  }
  return {};
}

bool is_reason(CaptureFault fault) { return fault == CaptureFault::dropped || fault == CaptureFault::resumed; }

bool explains(const CaptureFinding& reason, const CaptureFinding& loss) {
  return loss.frame <= reason.frame && reason.frame <= loss.frame + loss.count;
}

void explain(CaptureFinding& loss, CaptureFault reason) {
  loss.fault = reason;
  if (reason == CaptureFault::resumed) loss.count = 0;  // the time between the sessions is not known
}

void sort_by_frame(std::vector<CaptureFinding>& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const CaptureFinding& a, const CaptureFinding& b) { return a.frame < b.frame; });
}

}  // namespace

SessionFaults::SessionFaults(double fs_Hz) : fs_Hz_(fs_Hz) {}

void SessionFaults::keep(CaptureFinding finding) {
  if (faults_.size() < kMaxFaults) faults_.push_back(std::move(finding));
}

std::optional<CaptureFinding> SessionFaults::add(const SampleLoss& loss) {
  const std::uint64_t end = loss.frame + loss.frames;
  if (loss.channel) {
    const auto run = runs_.find(*loss.channel);
    const bool goes_on = run != runs_.end() && run->second.fault < faults_.size() &&
                         loss.frame <= run->second.end + static_cast<std::uint64_t>(kOneFault_s * fs_Hz_);
    if (goes_on) {
      faults_[run->second.fault].count += loss.frames;
      run->second.end = end;
      return {};
    }
    runs_[*loss.channel] = {.fault = faults_.size(), .end = end};
    const CaptureFinding fault{
        .fault = CaptureFault::not_a_number, .frame = loss.frame, .count = loss.frames, .channel = loss.channel};
    keep(fault);
    return fault;
  }
  CaptureFinding fault{
      .fault = loss.overrun ? CaptureFault::overrun : CaptureFault::gap, .frame = loss.frame, .count = loss.frames};
  const auto reason = std::find_if(reasons_.begin(), reasons_.end(),
                                   [&](const CaptureFinding& known) { return explains(known, fault); });
  if (reason != reasons_.end()) {
    explain(fault, reason->fault);
    reasons_.erase(reason);
  }
  keep(fault);
  return fault;
}

void SessionFaults::add(const CaptureFinding& finding) {
  if (!is_loss(finding.fault)) {
    if (stored_kind(finding.fault)) pending_.push_back(finding);
    return;
  }
  if (!is_reason(finding.fault)) return;
  const auto loss = std::find_if(faults_.begin(), faults_.end(), [&](const CaptureFinding& fault) {
    return (fault.fault == CaptureFault::gap || fault.fault == CaptureFault::overrun) && explains(finding, fault);
  });
  if (loss != faults_.end()) return explain(*loss, finding.fault);
  if (reasons_.size() < kMaxFaults) reasons_.push_back(finding);
}

void SessionFaults::add_past(const CaptureFinding& finding, std::uint64_t first_frame) {
  if (is_reason(finding.fault) && finding.frame >= first_frame) return add(finding);
  if (!stored_kind(finding.fault) || (is_loss(finding.fault) && finding.frame >= first_frame)) return;
  if (finding.fault == CaptureFault::resumed) return;  // before the first sample: nothing is missing
  CaptureFinding past = finding;
  const bool frames_lost = is_loss(finding.fault) && finding.fault != CaptureFault::not_a_number;
  if (frames_lost) past.frame -= std::min(past.frame, past.count);  // a finding states the frame after a loss
  keep(std::move(past));
}

std::vector<CaptureFinding> SessionFaults::finish(bool finished_before) {
  std::vector<CaptureFinding> out = std::exchange(pending_, {});
  if (finished_before)
    std::erase_if(out, [](const CaptureFinding& finding) { return finding.fault != CaptureFault::clock_drift; });
  // The remaining reasons are frames that were dropped after the last frame that arrived.
  std::erase_if(reasons_, [](const CaptureFinding& reason) { return reason.fault == CaptureFault::resumed; });
  if (!finished_before) out.insert(out.end(), reasons_.begin(), reasons_.end());
  reasons_.clear();
  sort_by_frame(out);
  for (const CaptureFinding& finding : out) keep(finding);
  return out;
}

std::vector<acquire::RecordFault> SessionFaults::for_record(const std::vector<Row>& rows) const {
  std::vector<CaptureFinding> sorted = faults_;
  sort_by_frame(sorted);
  std::vector<acquire::RecordFault> out;
  for (const CaptureFinding& fault : sorted) {
    const auto in_row = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
      const std::uint64_t frames = is_loss(fault.fault) ? std::max<std::uint64_t>(fault.count, 1) : 1;
      return row.frame < fault.frame + frames && fault.frame < row.frame + row.samples;
    });
    out.push_back({.kind = stored_kind(fault.fault).value_or(FaultKind::failed),
                   .row = in_row == rows.end() ? -1 : static_cast<int>(in_row - rows.begin()),
                   .time_s = static_cast<double>(fault.frame) / fs_Hz_,
                   .value = is_loss(fault.fault) ? static_cast<double>(fault.count) : fault.value});
  }
  return out;
}

}  // namespace percuss::pipeline
