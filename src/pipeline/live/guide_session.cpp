#include <algorithm>
#include <numeric>
#include <utility>

#include "pipeline/live/guide.hpp"

namespace percuss::pipeline {
namespace {

using Kind = SessionEvent::Kind;

constexpr std::size_t kMaxFaults = 100'000;

}  // namespace

void Guide::resume_from(const std::vector<SessionEvent>& events) {
  std::uint64_t blow = 0;
  for (const SessionEvent& event : events) {
    if (event.kind == Kind::blow) {
      blow = event.frame;
      past_[blow].blow = event;
    } else if (event.kind == Kind::regraded) {
      past_[event.frame].consequences.push_back(event);  // is written before its blow
    } else if (event.kind == Kind::enough) {
      past_[blow].consequences.push_back(event);
    } else {
      past_commands_.push_back(event);
    }
  }
}

// Applies a blow of the interrupted session with what followed from it. False: this blow is new.
bool Guide::repeat_past(const SessionEvent& blow) {
  const auto past = past_.find(blow.frame);
  if (past == past_.end() || !past->second.blow) return false;
  for (const SessionEvent& consequence : past->second.consequences) {
    if (consequence.kind == Kind::regraded) session_.apply(consequence);
  }
  session_.apply(blow);
  for (const SessionEvent& consequence : past->second.consequences) {
    if (consequence.kind == Kind::enough) session_.apply(consequence);
  }
  past_.erase(past);
  return true;
}

void Guide::command(SessionEvent::Kind kind, int point) {
  const SessionEvent event{.kind = kind, .frame = history_.end_frame(), .point = point};
  log_.append_event(json_of(event));
  commands_.push_back(event);
  apply_commands(!started_ || kind == Kind::finish);
}

void Guide::apply_commands(bool last) {
  while (!commands_.empty()) {
    const SessionEvent event = commands_.front();
    const bool blow_before = !windows_.empty() && windows_.front().event.first < event.frame;
    if (!last && event.kind != Kind::finish && (blow_before || !all_known_before(event.frame))) return;
    commands_.pop_front();
    session_.apply(event);
    observer_.on_command(event);
  }
}

void Guide::log_and_apply(const SessionEvent& event) {
  log_.append_event(json_of(event));
  session_.apply(event);
}

void Guide::check_goals() {
  if (options_.until.empty() || session_.finished()) return;
  if (!all_met(options_.until, session_quality(accepted_record(), options_.analysis))) return;
  observer_.on_goals_met();
  log_and_apply({.kind = Kind::enough, .frame = history_.end_frame()});
}

std::uint64_t Guide::frame_before_first_blow(double time_s) const {
  const std::uint64_t first = session_.blows().empty() ? (windows_.empty() ? newest_frame() : windows_.front().first)
                                                       : session_.blows().front().frame;
  const auto before = static_cast<std::uint64_t>(time_s * fs_Hz_);
  return std::max(start_frame_, first > before ? first - before : 0);
}

void Guide::add_fault(acquire::FaultKind kind, std::uint64_t frame, double value) {
  if (faults_.size() < kMaxFaults) faults_.push_back({.kind = kind, .frame = frame, .value = value});
}

acquire::Record Guide::record_of(std::vector<std::size_t> rows) const {
  acquire::Record record = channels_.description;
  for (const std::size_t row : rows) {
    const Session::Blow& blow = session_.blows()[row];
    record.rows.push_back({.samples = store_->samples(), .point = blow.point, .mark = blow.mark});
  }
  read_from(store_, std::move(rows), record);
  return record;
}

acquire::Record Guide::accepted_record() const { return record_of(session_.accepted_rows()); }

acquire::Record Guide::record() const {
  std::vector<std::size_t> rows(session_.blows().size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  acquire::Record record = record_of(std::move(rows));
  for (const Fault& fault : faults_) {
    const auto& blows = session_.blows();
    const auto in_blow = std::find_if(blows.begin(), blows.end(), [&](const Session::Blow& blow) {
      return blow.frame <= fault.frame && fault.frame < blow.frame + store_->samples();
    });
    record.faults.push_back({.kind = fault.kind,
                             .row = in_blow == blows.end() ? -1 : static_cast<int>(in_blow - blows.begin()),
                             .time_s = static_cast<double>(fault.frame) / fs_Hz_,
                             .value = fault.value});
  }
  return record;
}

}  // namespace percuss::pipeline
