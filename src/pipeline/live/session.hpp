#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "acquire/record/row_mark.hpp"

namespace percuss::pipeline {

/// What a session shall measure.
struct SessionPlan {
  std::vector<int> points{0};  // in the order of the test
  std::size_t hits = 5;        // accepted blows at each
};

/// A blow, a consequence of it (regraded, enough) or a command of the operator, at a frame of the stream.
struct SessionEvent {
  enum class Kind { blow, regraded, undo, redo, next, go_to, pause, finish, enough };
  Kind kind = Kind::blow;
  std::uint64_t frame = 0;                         // blow: the first of its samples; else the newest frame
  acquire::RowMark mark = acquire::RowMark::none;  // blow, regraded
  std::size_t row = 0;                             // regraded
  int point = 0;                                   // go_to, redo; blow: where it was
  std::string message{};                           // blow: the verdict for people
  double peak_N = 0, bandwidth_Hz = 0;             // blow
  std::optional<bool> differ{};                    // blow: whether blows of its point differ, if compared
  bool operator==(const SessionEvent&) const = default;
};

/// One line of JSON, and back.
/// errors  InputError at `where`: not such an event.
std::string json_of(const SessionEvent& event);
SessionEvent parse_session_event(const std::string& json, const std::string& where);

/// The state of a session: a function of its plan and of the events so far. It knows neither samples nor a terminal.
class SessionState {
 public:
  explicit SessionState(SessionPlan plan);

  struct Blow {
    std::uint64_t frame = 0;
    int point = 0;
    acquire::RowMark mark = acquire::RowMark::none;
    double peak_N = 0, bandwidth_Hz = 0;
    bool accepted() const { return mark == acquire::RowMark::none; }
  };

  /// Events that do not apply (undo without a blow, a point that is not in the plan) change nothing.
  void apply(const SessionEvent& event);

  const SessionPlan& plan() const { return plan_; }
  const std::vector<Blow>& blows() const { return blows_; }  // row by row
  int point() const { return plan_.points[current_]; }
  bool paused() const { return paused_; }
  /// The operator finished, or every point has its blows.
  bool finished() const { return finished_; }
  bool complete() const { return complete_points() == plan_.points.size(); }
  std::size_t complete_points() const;
  std::size_t accepted_at(int point) const;
  std::size_t accepted() const;
  /// Blows that the operator took back: undo, redo.
  std::size_t undone() const;
  /// Rows of the accepted blows at a point.
  std::vector<std::size_t> accepted_rows(int point) const;
  std::vector<std::size_t> accepted_rows() const;
  bool has_point(int point) const;
  /// Whether the blows at this point differ, and are too few to tell which is wrong.
  bool needs_blows_to_compare() const;
  /// Points whose accepted blows differ.
  std::vector<int> doubtful_points() const;

 private:
  bool done_at(std::size_t index) const;
  /// Has its blows, and needs no more of them, or the operator has called them enough.
  bool settled(std::size_t index) const;
  bool blows_differ(int point) const;
  /// Whether the blows of a point differ, and further ones can tell which is wrong. Not where the blows of most other
  /// points differ, too: then noise is the cause.
  bool needs_more_blows(std::size_t index) const;
  bool go_on();
  void advance();
  void undo();
  void redo(int point);
  void go_to(int point);

  SessionPlan plan_;
  std::vector<Blow> blows_;
  std::vector<bool> enough_;  // [points]: fewer blows than planned suffice
  std::set<int> differing_;   // points
  std::size_t current_ = 0;
  bool paused_ = false, finished_ = false;
};

}  // namespace percuss::pipeline
