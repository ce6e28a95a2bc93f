#include "pipeline/live/session.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pipeline/hits/hit_consistency.hpp"

namespace percuss::pipeline {

namespace {

using acquire::RowMark;
using Kind = SessionEvent::Kind;

// From this many other doubtful points on, noise may be the cause, not a wrong blow.
constexpr std::size_t kNoisyPoints = 3;

}  // namespace

SessionState::SessionState(SessionPlan plan) : plan_(std::move(plan)), enough_(plan_.points.size()) {}

bool SessionState::has_point(int point) const {
  return std::find(plan_.points.begin(), plan_.points.end(), point) != plan_.points.end();
}

std::vector<std::size_t> SessionState::accepted_rows(int point) const {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < blows_.size(); ++row) {
    if (blows_[row].accepted() && blows_[row].point == point) rows.push_back(row);
  }
  return rows;
}

std::vector<std::size_t> SessionState::accepted_rows() const {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < blows_.size(); ++row) {
    if (blows_[row].accepted()) rows.push_back(row);
  }
  return rows;
}

std::size_t SessionState::accepted_at(int point) const { return accepted_rows(point).size(); }
std::size_t SessionState::accepted() const { return accepted_rows().size(); }

std::size_t SessionState::undone() const {
  return static_cast<std::size_t>(std::count_if(blows_.begin(), blows_.end(), [](const Blow& blow) {
    return blow.mark == RowMark::undone || blow.mark == RowMark::redone;
  }));
}

bool SessionState::done_at(std::size_t index) const {
  const std::size_t count = accepted_at(plan_.points[index]);
  return count >= plan_.hits || (enough_[index] && count > 0);
}

std::size_t SessionState::complete_points() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < plan_.points.size(); ++i) count += settled(i) ? 1U : 0U;
  return count;
}

// Goes to the next point that is not settled, after the current one and then from the first. False: all others are.
bool SessionState::go_on() {
  for (std::size_t step = 1; step < plan_.points.size(); ++step) {
    const std::size_t index = (current_ + step) % plan_.points.size();
    if (settled(index)) continue;
    current_ = index;
    return true;
  }
  return false;
}

bool SessionState::settled(std::size_t index) const {
  return done_at(index) && (enough_[index] || !needs_more_blows(index));
}

bool SessionState::blows_differ(int point) const { return differing_.contains(point) && accepted_at(point) > 0; }

bool SessionState::needs_blows_to_compare() const {
  return blows_differ(point()) && accepted_at(point()) < kMinHitsToFindOutlier;
}

std::vector<int> SessionState::doubtful_points() const {
  std::vector<int> out;
  std::copy_if(plan_.points.begin(), plan_.points.end(), std::back_inserter(out),
               [this](int point) { return blows_differ(point); });
  return out;
}

bool SessionState::needs_more_blows(std::size_t index) const {
  const int point = plan_.points[index];
  if (!blows_differ(point) || accepted_at(point) >= std::max(kMinHitsToFindOutlier, plan_.hits + 1)) return false;
  std::size_t others = 0, others_differ = 0;
  for (const int other : plan_.points) {
    if (other == point || accepted_at(other) == 0) continue;
    ++others;
    others_differ += blows_differ(other) ? 1U : 0U;
  }
  return others_differ < kNoisyPoints || 2 * others_differ <= others;
}

void SessionState::advance() {
  if (settled(current_) && !go_on()) finished_ = true;
}

void SessionState::undo() {
  const auto last = std::find_if(blows_.rbegin(), blows_.rend(), [](const Blow& blow) { return blow.accepted(); });
  if (last == blows_.rend()) return;
  last->mark = RowMark::undone;
  go_to(last->point);
  enough_[current_] = false;
}

void SessionState::redo(int point) {
  if (!has_point(point)) return;
  for (const std::size_t row : accepted_rows(point)) blows_[row].mark = RowMark::redone;
  go_to(point);
  enough_[current_] = false;
}

void SessionState::go_to(int point) {
  const auto at = std::find(plan_.points.begin(), plan_.points.end(), point);
  if (at != plan_.points.end()) current_ = static_cast<std::size_t>(at - plan_.points.begin());
}

void SessionState::apply(const SessionEvent& event) {
  if (finished_) return;
  switch (event.kind) {
    case Kind::blow:
      blows_.push_back({.frame = event.frame,
                        .point = point(),
                        .mark = event.mark,
                        .peak_N = event.peak_N,
                        .bandwidth_Hz = event.bandwidth_Hz});
      if (event.differ && *event.differ) differing_.insert(point());
      if (event.differ && !*event.differ) differing_.erase(point());
      break;
    case Kind::regraded:
      if (event.row < blows_.size() && blows_[event.row].accepted()) blows_[event.row].mark = event.mark;
      return;  // the blow that caused it follows, or has been counted
    case Kind::undo:
      return undo();
    case Kind::redo:
      return redo(event.point);
    case Kind::next:
      go_on();
      return;
    case Kind::go_to:
      return go_to(event.point);
    case Kind::pause:
      paused_ = !paused_;
      return;
    case Kind::finish:
      finished_ = true;
      return;
    case Kind::enough:
      enough_[current_] = true;
      break;
  }
  advance();
}

}  // namespace percuss::pipeline
