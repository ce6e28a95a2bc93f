#pragma once
#include <optional>
#include <set>
#include <string>

#include "acquire/live/sample_stream.hpp"
#include "commands/record/record_flags.hpp"
#include "commands/record/record_result.hpp"
#include "commands/record/record_terminal.hpp"
#include "pipeline/live/guidance_text.hpp"
#include "pipeline/live/guide.hpp"
#include "pipeline/live/quality_worker.hpp"

namespace percuss::tools {

/// Tells the operator what the guide does: a line and a bell per blow, and the prompt on a terminal.
class RecordScreen : public pipeline::GuideObserver {
 public:
  RecordScreen(RecordTerminal& terminal, const RecordFlags& flags, const pipeline::GuideOptions& options);

  void begin(const acquire::StreamFormat& format, const pipeline::Guide& guide);
  void resumed(const pipeline::Guide& guide);
  void note(const std::string& text);
  /// Shows the prompt and, on a terminal, the problems of the test and the precision of its modes. Names goals whose
  /// modes were not found, with or without a terminal.
  void update(const pipeline::Guide& guide);
  /// The summary. Names accepted blows that the analysis of all blows rejects.
  void end(const pipeline::Guide& guide, const SessionResult& result);

  void on_blow(const pipeline::BlowReport& blow) override;
  void on_regraded(std::size_t row, acquire::RowMark mark) override;
  void on_command(const pipeline::SessionEvent& command, std::size_t undone) override;
  void on_length(std::size_t samples, bool cut_short) override;
  void on_left_out(std::uint64_t frame, bool too_early) override;
  void on_silent_hammer() override;
  void on_long_push(const pipeline::LongPush& push) override;
  void on_fault(const acquire::CaptureFinding& fault) override;
  void on_goals_met() override;

 private:
  void show_quality(const pipeline::SessionQuality& quality);
  void show_missing_goals(const pipeline::SessionQuality& quality);
  void show_problems(const pipeline::SessionQuality& quality);

  RecordTerminal& terminal_;
  const RecordFlags& flags_;
  pipeline::SessionPlan plan_;
  std::vector<pipeline::PrecisionGoal> goals_;
  std::optional<std::pair<double, double>> band_Hz_;
  pipeline::RovingPart roving_;
  const pipeline::Guide* guide_ = nullptr;
  double fs_Hz_ = 0;
  bool silent_ = false;          // while the journal is replayed
  bool ask_ = false;             // the blows that count have changed
  bool discard_ = false;         // blows that counted before do not count any longer
  std::set<std::string> shown_;  // problems of the test, and goals
  std::optional<pipeline::QualityWorker> worker_;
};

}  // namespace percuss::tools
