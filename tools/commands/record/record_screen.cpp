#include "commands/record/record_screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "core/error.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::tools {
namespace {

using Kind = pipeline::SessionEvent::Kind;

constexpr const char* kKeys = "  [space pause, u undo, r redo, n next, g go to, q finish]";
constexpr const char* kShortKeys = "  [space u r n g q]";

std::string command_text(Kind kind, std::size_t undone, const pipeline::SessionState& session) {
  const std::string place =
      pipeline::place_text(session.plan(), session.point(), session.accepted_at(session.point()) + 1);
  switch (kind) {
    case Kind::undo:
      return (undone > 0 ? "the last accepted blow is undone; next: " : "no blow counts yet; next: ") + place;
    case Kind::redo:
      return (undone > 0 ? "the blows of this point are undone; next: "
                         : "no blow counts at this point (u undoes the last one of all); next: ") +
             place;
    case Kind::next:
    case Kind::go_to:
      return "next: " + place;
    case Kind::pause:
      return session.paused() ? "paused: blows do not count" : "goes on; next: " + place;
    case Kind::finish:
      return "finished by the operator";
    default:
      return {};
  }
}

// A goal for a mode that the blows do not show.
std::string missing_goal_text(const pipeline::PrecisionGoal& goal, const pipeline::SessionQuality& quality) {
  std::vector<std::string> names;
  for (std::size_t m = 0; m < quality.modes.size(); ++m) names.push_back(pipeline::name_of(quality.modes[m], m));
  return fmt::format("! the goal {} names none of the modes found so far: {}", goal.text(), fmt::join(names, ", "));
}

}  // namespace

RecordScreen::RecordScreen(RecordTerminal& terminal, const RecordFlags& flags, const pipeline::GuideOptions& options)
    : terminal_(terminal),
      flags_(flags),
      plan_(options.plan),
      goals_(options.until),
      band_Hz_(options.analysis.band_Hz),
      roving_(flags.roving == "sensor" ? pipeline::RovingPart::sensor : pipeline::RovingPart::hammer) {
  if (terminal.interactive() || (!goals_.empty() && !flags.quiet)) worker_.emplace(options.analysis);
}

void RecordScreen::begin(const acquire::StreamFormat& format, const pipeline::Guide& guide) {
  guide_ = &guide;
  fs_Hz_ = format.fs_Hz;
  const pipeline::LiveChannels& channels = guide.channels();
  note(fmt::format("{}: {:.6g} Hz, hammer on channel {}, response{} on {}", format.device, format.fs_Hz,
                   channels.force_number, channels.accel.size() == 1 ? "" : "s",
                   fmt::join(channels.accel_numbers, ", ")));
  for (const Message& message : channels.notes) note(message.text);
  if (band_Hz_ && format.fs_Hz < pipeline::kRateOverBand * band_Hz_->second) {
    note(fmt::format(
        "! the band ends at {:.6g} Hz, where a recorder's filter may end at {:.0f} Hz: record at {:.0f} Hz or "
        "more, or end the band lower",
        band_Hz_->second, format.fs_Hz / pipeline::kRateOverBand, pipeline::kRateOverBand * band_Hz_->second));
  }
  silent_ = !flags_.resume.empty();
}

void RecordScreen::resumed(const pipeline::Guide& guide) {
  silent_ = false;
  note(fmt::format("resumed after {}", pipeline::summary_text(guide.session())));
}

void RecordScreen::note(const std::string& text) {
  if (!flags_.quiet) terminal_.line(text);
}

// Shows each problem once.
void RecordScreen::show_problems(const pipeline::SessionQuality& quality) {
  for (const pipeline::SessionProblem& problem : quality.problems) {
    if (shown_.insert(problem.code).second) note("! " + problem.text);
  }
}

// Names each goal once, as soon as there are modes.
void RecordScreen::show_missing_goals(const pipeline::SessionQuality& quality) {
  if (quality.modes.empty()) return;
  for (const pipeline::PrecisionGoal& goal : goals_) {
    if (!pipeline::mode_of(goal, quality) && shown_.insert(goal.text()).second) note(missing_goal_text(goal, quality));
  }
}

void RecordScreen::show_quality(const pipeline::SessionQuality& quality) {
  show_missing_goals(quality);
  if (!terminal_.interactive()) return;
  show_problems(quality);
  const bool newest = quality.blows == guide_->session().accepted();
  const std::string after =
      newest ? "" : fmt::format("after {} blow{}: ", quality.blows, quality.blows == 1 ? "" : "s");
  note("  " + after + pipeline::quality_text(quality));
  const std::string outlook = pipeline::outlook_text(quality, goals_);
  if (!outlook.empty()) note("  " + outlook);
}

void RecordScreen::update(const pipeline::Guide& guide) {
  if (!worker_) return;
  if (std::exchange(discard_, false)) worker_->discard();
  if (std::exchange(ask_, false)) worker_->ask(guide.record());
  if (const auto quality = worker_->take()) show_quality(*quality);
  const std::string state =
      guide.collecting() ? "listening to the decay" : pipeline::prompt_text(guide.session(), roving_);
  terminal_.prompt(state, kKeys, kShortKeys);
}

void RecordScreen::on_blow(const pipeline::BlowReport& blow) {
  if (blow.repeated) return;
  note(pipeline::blow_text(blow, guide_->channels(), plan_));
  if (silent_) return;  // replayed from the journal
  terminal_.bell();
  ask_ = ask_ || blow.grade.accepted();
}

void RecordScreen::on_regraded(std::size_t row, acquire::RowMark mark) {
  if (silent_) return;
  ask_ = discard_ = true;
  note(fmt::format("  hit {} does not count any longer: {}", row + 1, acquire::reason_of(mark)));
}

void RecordScreen::on_command(const pipeline::SessionEvent& command, std::size_t undone) {
  if (silent_) return;
  note("  " + command_text(command.kind, undone, guide_->session()));
  discard_ = discard_ || command.kind == Kind::undo || command.kind == Kind::redo;
  ask_ = ask_ || discard_;
}

void RecordScreen::on_length(std::size_t samples, bool cut_short) {
  if (silent_) return;
  const std::string length = fmt::format("  each blow takes {:.2f} s", static_cast<double>(samples) / fs_Hz_);
  note(cut_short ? length +
                       ": the first blow was cut short before its decay had ended; to record longer blows, start a "
                       "new session and let the first one decay, or state the length"
                 : length);
}

void RecordScreen::on_left_out(std::uint64_t frame, bool too_early) {
  if (silent_) return;
  const bool first = guide_->session().blows().empty() && !too_early;
  note(pipeline::left_out_text(static_cast<double>(frame) / fs_Hz_, too_early) +
       (first ? fmt::format(". Is the hammer on channel {}?", guide_->channels().force_number) : ""));
}

void RecordScreen::on_silent_hammer() {
  if (silent_) return;
  note(pipeline::silent_hammer_text(guide_->channels(), flags_.trigger_N, !guide_->session().blows().empty()));
  terminal_.bell();
}

void RecordScreen::on_long_push(const pipeline::LongPush& push) {
  if (!silent_) note(pipeline::long_push_text(push, static_cast<double>(push.peak) / fs_Hz_));
}

void RecordScreen::on_fault(const acquire::CaptureFinding& fault) {
  if (!silent_ && fault.fault != acquire::CaptureFault::resumed) note(pipeline::fault_text(fault, guide_->channels()));
}

void RecordScreen::on_goals_met() {
  if (!silent_) note("  the goal is met");
}

void RecordScreen::end(const pipeline::Guide& guide, const SessionResult& result) {
  terminal_.prompt("");
  note(fmt::format("{}: {}", flags_.output, pipeline::summary_text(guide.session())));
  if (guide.session().accepted() == 0) return;
  for (const pipeline::SessionProblem& problem : result.quality().problems) note("! " + problem.text);
  note(pipeline::quality_text(result.quality()));
  if (!goals_.empty()) note(pipeline::goals_text(result.quality(), goals_));
  if (const std::size_t more = result.further_warnings(); more > 0) {
    note(fmt::format("  the analysis has {} further warning{}: {}", more, more == 1 ? "" : "s",
                     analysis_command(flags_)));
  }
  try {
    for (const pipeline::AnalysedHit& hit : result.analysis().hits()) {
      const bool counted = guide.session().blows()[hit.hit.row].accepted();
      if (hit.accepted || !counted || hit.hit.findings.empty()) continue;
      note(fmt::format("  the analysis of all blows leaves out hit {}: {}", hit.hit.row + 1,
                       hit.hit.findings.front().message));
    }
  } catch (const InputError&) {  // the report of the analysis says why
  }
}

}  // namespace percuss::tools
