#include <algorithm>
#include <numeric>
#include <utility>

#include "pipeline/live/guide.hpp"

namespace percuss::pipeline {
namespace {

using Kind = SessionEvent::Kind;

}  // namespace

void Guide::resume_from(const std::vector<SessionEvent>& events, const std::vector<acquire::CaptureFinding>& findings,
                        std::uint64_t first_frame) {
  for (const acquire::CaptureFinding& finding : findings) faults_.add_past(finding, first_frame);
  std::uint64_t blow = 0;
  for (const SessionEvent& event : events) {
    if (event.kind == Kind::blow) {
      blow = event.frame;
      past_[blow].blow = event;
    } else if (event.kind == Kind::regraded) {
      past_[event.frame].consequences.push_back(event);  // the journal holds it before its blow
    } else if (event.kind == Kind::enough) {
      past_[blow].consequences.push_back(event);
    } else {
      past_commands_.push_back(event);
    }
  }
}

// Applies a blow of the interrupted session and its consequences. False: this blow is new.
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
  // A device that delivers nothing must not delay the end: a second request ends the session at once.
  const bool asked_before = std::any_of(commands_.begin(), commands_.end(),
                                        [](const SessionEvent& other) { return other.kind == Kind::finish; });
  commands_.push_back(event);
  apply_commands(!started_ || (kind == Kind::finish && asked_before));
}

void Guide::apply_commands(bool at_once) {
  while (!commands_.empty()) {
    const SessionEvent event = commands_.front();
    const bool blow_before = !windows_.empty() && windows_.front().event.first < event.frame;
    if (!at_once && (blow_before || !all_known_before(event.frame))) return;
    commands_.pop_front();
    const std::size_t before = session_.accepted();
    session_.apply(event);
    observer_.on_command(event, before - session_.accepted());
  }
}

void Guide::log_and_apply(const SessionEvent& event) {
  log_.append_event(json_of(event));
  session_.apply(event);
}

void Guide::check_goals() {
  if (options_.until.empty() || session_.finished() || session_.needs_blows_to_compare()) return;
  if (!all_met(options_.until, session_quality(record(), options_.analysis))) return;
  observer_.on_goals_met();
  log_and_apply({.kind = Kind::enough, .frame = history_.end_frame()});
}

std::uint64_t Guide::frame_before_first_blow(double time_s) const {
  const std::uint64_t first = session_.blows().empty() ? (windows_.empty() ? newest_frame() : windows_.front().first)
                                                       : session_.blows().front().frame;
  const auto before = static_cast<std::uint64_t>(time_s * fs_Hz_);
  return std::max(start_frame_, first > before ? first - before : 0);
}

bool Guide::is_used(std::size_t channel) const {
  return channel == channels_.force ||
         std::find(channels_.accel.begin(), channels_.accel.end(), channel) != channels_.accel.end();
}

// Adds the losses up to a frame, and reports them. All blows before it have been judged.
void Guide::note_losses(std::uint64_t frame) {
  if (complete_ || frame <= noted_) return;
  for (SampleLoss loss : history_.losses(noted_, frame)) {
    if (loss.channel) {
      const std::uint64_t first = std::max(loss.frame, noted_), last = std::min(loss.frame + loss.frames, frame);
      loss = {.frame = first, .frames = last - first, .channel = loss.channel};
      if (!is_used(*loss.channel)) continue;
    } else if (loss.frame < noted_ || is_pause(loss)) {
      continue;
    }
    if (const auto fault = faults_.add(loss)) observer_.on_fault(*fault);
  }
  noted_ = frame;
}

acquire::Record Guide::record() const {
  acquire::Record record = channels_.description;
  std::vector<std::size_t> rows(session_.blows().size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  read_from(store_, std::move(rows), record);
  std::vector<SessionFaults::Row> places;
  for (const SessionState::Blow& blow : session_.blows()) {
    record.rows.push_back({.samples = store_->samples(), .point = blow.point, .mark = blow.mark});
    places.push_back({.frame = blow.frame, .samples = store_->samples()});
  }
  record.faults = faults_.for_record(places);
  if (!options_.date.empty()) record.files = {{.path = format_.device, .date = options_.date}};
  return record;
}

}  // namespace percuss::pipeline
