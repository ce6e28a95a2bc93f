#pragma once
#include <cstddef>
#include <cstdint>

#include "acquire/record/record.hpp"
#include "pipeline/live/blow_grading.hpp"
#include "pipeline/live/online_trigger.hpp"
#include "pipeline/live/session.hpp"
#include "pipeline/live/session_faults.hpp"

namespace percuss::pipeline {

/// A blow that has been judged.
struct BlowReport {
  std::size_t row = 0;
  std::uint64_t end_frame = 0;  // after its samples
  int point = 0;
  std::size_t blow = 1;  // of SessionPlan::hits: its number among the accepted blows of its point, if it counts
  BlowGrade grade;
  // Whether its message may advise another gain: it is a first blow, and not much weaker than an earlier one.
  bool may_advise_gain = false;
  bool repeated = false;  // its verdict was given in the interrupted session
  bool one_more = false;  // the point has its blows, but they differ: a further one helps to decide
};

/// Receives the events of a session from its Guide (guide.hpp), on the thread that feeds it samples. No function may
/// wait.
class GuideObserver {
 public:
  GuideObserver() = default;
  GuideObserver(const GuideObserver&) = delete;
  GuideObserver& operator=(const GuideObserver&) = delete;
  virtual ~GuideObserver() = default;

  virtual void on_blow(const BlowReport& blow) = 0;
  /// An accepted blow does not count any longer.
  virtual void on_regraded(std::size_t /*row*/, acquire::RowMark /*mark*/) {}
  /// A command was applied; `undone` accepted blows do not count any longer.
  virtual void on_command(const SessionEvent& /*command*/, std::size_t /*undone*/) {}
  /// The length of all blows was chosen. `cut_short`: by the next blow or lost samples, before the decay had ended.
  virtual void on_length(std::size_t /*samples*/, bool /*cut_short*/) {}
  /// A blow is not recorded. Its force first exceeds the threshold at this frame. `too_early`: too few samples precede
  /// it to know the noise. Otherwise the next blow, lost samples or the end of the samples came before its decay could
  /// set the length of all blows.
  virtual void on_left_out(std::uint64_t /*frame*/, bool /*too_early*/) {}
  /// A response moves as after a blow, but the force does not: before the first blow, or between two.
  virtual void on_silent_hammer() {}
  /// A push of the force was too long for a blow, but as strong as one.
  virtual void on_long_push(const LongPush& /*push*/) {}
  /// A fault of the capture, after the verdicts on the blows before it. `frame` is the first lost one; a count of
  /// samples that are no numbers may still grow.
  virtual void on_fault(const acquire::CaptureFinding& /*fault*/) {}
  virtual void on_goals_met() {}
};

}  // namespace percuss::pipeline
