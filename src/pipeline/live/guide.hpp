#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquire/live/sample_stream.hpp"
#include "acquire/record/record.hpp"
#include "pipeline/live/blow_grading.hpp"
#include "pipeline/live/guide_observer.hpp"
#include "pipeline/live/hammer_watch.hpp"
#include "pipeline/live/live_channels.hpp"
#include "pipeline/live/online_trigger.hpp"
#include "pipeline/live/row_store.hpp"
#include "pipeline/live/sample_history.hpp"
#include "pipeline/live/session.hpp"
#include "pipeline/live/session_faults.hpp"
#include "pipeline/live/until.hpp"

namespace percuss::pipeline {

struct GuideOptions {
  SessionPlan plan;
  AnalysisOptions analysis;
  std::optional<double> trigger_N, pretrigger_s;
  std::optional<double> length_s;  // of a blow's samples; default: until the first blow's decay has ended
  std::vector<PrecisionGoal> until;
  std::string folder = ".";                       // with room for the samples of the blows
  std::vector<std::vector<double>> geometry{};    // as acquire::Record
  std::vector<acquire::TraceLine> trace_lines{};  // likewise
  std::vector<acquire::TraceFace> trace_faces{};  // likewise
  std::string date{};                             // of the test; empty: unknown
  bool sensor_moves = false;                      // from point to point, instead of the hammer
};

/// Guides a session: finds blows in the stream of samples, judges each, keeps its samples and counts it. The state
/// follows from the samples and the commands alone, not from time or from the size of the blocks. Knows no terminal.
class Guide {
 public:
  /// errors  InputError: unusable channels; no room in `folder`.
  Guide(const acquire::StreamFormat& format, LiveChannels channels, GuideOptions options, acquire::SessionLog& log,
        GuideObserver& observer);

  /// Goes on from the events of an interrupted session: their verdicts and commands apply again when the samples of the
  /// journal are taken. Its samples begin at `first_frame`. Call it first.
  void resume_from(const std::vector<SessionEvent>& events, const std::vector<acquire::CaptureFinding>& findings = {},
                   std::uint64_t first_frame = 0);
  void take(acquire::SampleBlock block);
  /// The operator's choice, after the newest frame. It applies after the blows that began before it.
  void command(SessionEvent::Kind kind, int point = 0);
  /// Adds what the capture states about the stream. Losses are known from the samples.
  void add_finding(const acquire::CaptureFinding& finding) { faults_.add(finding); }
  /// No more samples and findings will come: judges the last blow, and reports the faults after it to the observer.
  void finish();

  const SessionState& session() const { return session_; }
  const LiveChannels& channels() const { return channels_; }
  std::uint64_t newest_frame() const { return history_.end_frame(); }
  /// The frames in memory: they do not grow with the session.
  std::uint64_t kept_frames() const { return history_.end_frame() - history_.first_frame(); }
  /// A blow's samples are being collected.
  bool collecting() const { return !windows_.empty(); }
  /// A command waits for the blows that began before it.
  bool has_waiting_command() const { return !commands_.empty(); }
  /// The first frame of the first blow, less this time, but not before the start.
  std::uint64_t frame_before_first_blow(double time_s) const;
  std::optional<std::size_t> length() const { return length_; }

  /// The session as a record: one row per blow, rejected ones marked. Its samples stay available after the guide.
  acquire::Record record() const;

 private:
  struct Window {
    BlowEvent event;
    std::uint64_t first = 0;
    std::size_t horizon = 0;  // the next length to try
  };
  struct PastBlow {
    std::optional<SessionEvent> blow;
    std::vector<SessionEvent> consequences;  // regraded, enough
  };
  void take_whole(acquire::SampleBlock block);
  void feed_trigger(std::uint64_t from);
  void collect_events();
  /// Whether a push was meant as a blow. Pushes within a second are one handling of the hammer.
  bool is_attempt(const LongPush& push);
  void watch_hammer(std::uint64_t from);
  std::size_t pretrigger_of(std::size_t rise) const;
  std::uint64_t window_start(const BlowEvent& event) const;
  void advance(bool last);
  bool is_complete(const Window& window, bool last) const;
  bool all_known_before(std::uint64_t frame) const;
  /// False: more samples are needed. True with no length: the window is of no use.
  bool choose_length(Window& window, bool last);
  bool too_early(const Window& window) const;
  std::size_t missing_pretrigger(const Window& window) const;
  std::uint64_t undisturbed_end(const Window& window) const;
  bool is_pause(const SampleLoss& loss) const;
  /// Lost frames, and samples of the force that are no numbers.
  std::vector<SampleLoss> force_losses(std::uint64_t first, std::uint64_t last) const;
  void note_losses(std::uint64_t frame);
  bool is_used(std::size_t channel) const;
  void judge(const Window& window);
  bool may_advise_gain(const BlowGrade& grade) const;
  /// Adds the accepted blows that are weak beside the others, now that there are enough to tell.
  void regrade_weak(BlowGrade& grade) const;
  BlowGrade grade(const BlowSamples& samples, const Window& window) const;
  BlowCircumstances circumstances(const Window& window) const;
  /// Measures the motion before a blow, and keeps the smallest of each response: its noise.
  void note_rest(const Window& window);
  void apply_commands(bool at_once);
  void log_and_apply(const SessionEvent& event);
  bool repeat_past(const SessionEvent& blow);
  void check_goals();
  void forget();
  double typical(double SessionState::Blow::*value) const;
  /// The force at which blows were clipped, if it was one level; otherwise 0.
  double clipped_at_N() const;
  /// After a blow: watches for responses like those of blows.
  void watch_on(std::uint64_t from);
  void note_response(const BlowSamples& samples, const BlowGrade& grade);

  LiveChannels channels_;
  GuideOptions options_;
  acquire::SessionLog& log_;
  GuideObserver& observer_;
  const acquire::StreamFormat format_;
  double fs_Hz_;
  std::vector<double> full_scales_;  // [channels of the device]; 0: not known
  std::size_t pretrigger_;           // of a short pulse
  SessionState session_;
  SampleHistory history_;
  std::unique_ptr<OnlineTrigger> trigger_;
  std::optional<HammerWatch> watch_;
  std::uint64_t watch_from_ = 0;        // the decay of a blow is over
  std::vector<double> response_peaks_;  // of accepted blows, as the device delivers the first response
  std::uint64_t fed_ = 0;               // frames before it were given to the trigger
  const std::size_t rest_frames_;
  std::vector<BlowCircumstances::Rest> rest_;  // [responses], before the newest blow
  std::shared_ptr<RowStore> store_;
  std::deque<Window> windows_;
  std::optional<std::size_t> length_;
  bool length_by_end_ = false;      // the end of the recording cut the first blow short
  std::uint64_t previous_end_ = 0;  // of the last blow's samples
  std::uint64_t start_frame_ = 0;
  bool started_ = false;
  std::deque<SessionEvent> commands_;
  std::map<std::uint64_t, PastBlow> past_;  // by frame
  std::deque<SessionEvent> past_commands_;
  SessionFaults faults_;
  std::uint64_t noted_ = 0;  // losses before this frame are in faults_
  LongPush reported_push_;   // the last push that was reported to the observer
  bool complete_ = false;    // what happens after the last blow does not concern the session
};

}  // namespace percuss::pipeline
