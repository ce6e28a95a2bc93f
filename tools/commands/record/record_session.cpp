#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <utility>

#include "acquire/live/capture_stream.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/record/channel_list.hpp"
#include "commands/record/raw_terminal.hpp"
#include "commands/record/record_capture.hpp"
#include "commands/record/record_files.hpp"
#include "commands/record/record_flags.hpp"
#include "commands/record/record_plan.hpp"
#include "commands/record/record_result.hpp"
#include "commands/record/record_resume.hpp"
#include "commands/record/record_screen.hpp"
#include "commands/record/record_terminal.hpp"
#include "core/error.hpp"
#include "pipeline/live/guide.hpp"
#include "report/text/creation_time.hpp"
#include "report/text/version.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using acquire::CaptureFault, acquire::StreamEnd;
using Kind = pipeline::SessionEvent::Kind;

constexpr double kKeptBefore_s = 1;  // of silence before the first blow, in the journal

// The guide reports losses when the samples show them. Faults of the disk are reported at once.
void take_findings(acquire::CaptureStream& stream, pipeline::Guide& guide, RecordScreen& screen,
                   std::uint64_t& missing_frames) {
  for (const acquire::CaptureFinding& finding : stream.take_findings()) {
    guide.add_finding(finding);
    if (finding.fault == CaptureFault::not_in_journal) missing_frames += finding.count;
    if (finding.fault == CaptureFault::journal_failed || finding.fault == CaptureFault::not_in_journal)
      screen.note(acquire::finding_text(finding));
  }
}

std::string missing_point_text(std::size_t number, const std::vector<int>& points) {
  if (points.size() == 1) return fmt::format("there is no point {}; the test has one point", number);
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end());
  return fmt::format("there is no point {}; the geometry numbers its points from {} to {}", number, *lowest, *highest);
}

void press(const PressedKey& key, pipeline::Guide& guide, RecordScreen& screen) {
  const pipeline::SessionState& session = guide.session();
  // Ten digits may exceed an int. No point has the largest int as its number (acquire::kMaxPointNumber).
  const auto number = static_cast<int>(std::min<std::size_t>(key.number, std::numeric_limits<int>::max()));
  switch (key.key) {
    case RecordKey::pause:
      guide.command(Kind::pause);
      break;
    case RecordKey::undo:
      guide.command(Kind::undo);
      break;
    case RecordKey::redo:
      guide.command(Kind::redo, session.point());
      break;
    case RecordKey::next:
      guide.command(Kind::next);
      break;
    case RecordKey::finish:
      guide.command(Kind::finish);
      break;
    case RecordKey::go_to:
      if (!session.has_point(number)) return screen.note(missing_point_text(key.number, session.plan().points));
      guide.command(Kind::go_to, number);
      break;
  }
  if (guide.collecting() && guide.has_waiting_command()) {
    screen.note(key.key == RecordKey::finish
                    ? "  the session ends after the blow that is being recorded; q again ends it at once"
                    : "  the key applies after the blow that is being recorded");
  }
}

struct Ending {
  StreamEnd device = StreamEnd::none;
  std::uint64_t missing_frames = 0;  // not in the journal
  bool early = false;                // before every point had its blows
  bool broken = false;               // early, by a fault of the device or by a signal
};

// Records until the session is finished, the device ends or a signal arrives.
Ending record_blows(acquire::CaptureStream& stream, pipeline::Guide& guide, RecordTerminal& terminal,
                    RecordScreen& screen) {
  Ending ending;
  bool kept = false;
  while (!guide.session().finished() && SessionSignals::arrived() == 0) {
    while (const auto key = terminal.take_key()) press(*key, guide, screen);
    auto block = stream.next(20ms);
    if (block) guide.take(std::move(*block));
    if (!kept && (guide.collecting() || !guide.session().blows().empty())) {
      stream.keep_from(guide.frame_before_first_blow(kKeptBefore_s));
      kept = true;
    }
    take_findings(stream, guide, screen, ending.missing_frames);
    screen.update(guide);
    if (!block && stream.end() != StreamEnd::none) break;
  }
  ending.device = guide.session().finished() ? StreamEnd::none : stream.end();
  stream.stop();
  take_findings(stream, guide, screen, ending.missing_frames);
  guide.finish();
  const bool signal = SessionSignals::arrived() != 0;
  const bool done = guide.session().finished() || guide.session().complete();
  ending.early = (ending.device != StreamEnd::none || signal) && !done;
  ending.broken = ending.early && (signal || ending.device != StreamEnd::finished);
  return ending;
}

// If a blow cannot be stored, the error names the command that resumes the session from its journal.
Ending record_or_name_resume(const RecordFlags& flags, acquire::CaptureStream& stream, pipeline::Guide& guide,
                             RecordTerminal& terminal, RecordScreen& screen) {
  try {
    return record_blows(stream, guide, terminal, screen);
  } catch (const InputError& error) {
    throw InputError(error.problem(), error.where(),
                     fmt::format("{} ({})", error.remedy(), resume_command(flags.output)), error.options());
  }
}

int list_devices() {
  CommandLine line("percuss", "", report::version());
  add_devices(line);
  constexpr std::array kWords{"percuss", "devices"};
  return line.run(static_cast<int>(kWords.size()), kWords.data());
}

// Says that --force overwrote an unfinished session with blows.
void note_overwritten_session(const UnfinishedSession& earlier, const RecordFlags& flags) {
  if (earlier.journal.empty() || earlier.blows == 0U) return;
  print_note({}, {fmt::format("the unfinished session of {} is overwritten; lost: {}", one_line(flags.output),
                              earlier.content()),
                  {"force"}});
}

struct Outcome {
  int code = kOk;
  std::size_t accepted = 0;
  std::string document;  // for --json
};

// Takes the samples of an interrupted session.
void take_interrupted(const InterruptedSession& interrupted, const RecordFlags& flags, pipeline::Guide& guide,
                      RecordScreen& screen) {
  replay(interrupted, repeats_itself(flags.device), guide);
  if (const std::string torn = torn_text(interrupted); !torn.empty()) screen.note(torn);
  if (const auto missing = missing_frames(*interrupted.journal); missing > 0)
    screen.note(missing_text(missing, interrupted.journal->format().fs_Hz));
  screen.resumed(guide);
}

// Writes the file of a session with blows. Its journal stays if the session ended early.
void keep_session(const RecordFlags& flags, const acquire::Record& record, const Ending& ending, RecordScreen& screen) {
  write_session(flags, record);
  if (!ending.early) {
    fs::remove(journal_of(flags.output));  // the file is whole, and on the disk
    return;
  }
  if (ending.missing_frames > 0) screen.note(missing_text(ending.missing_frames, record.fs_Hz));
  if (ending.device == StreamEnd::finished && repeats_itself(flags.device))
    return screen.note("the file holds the blows so far; the device has no more of them");
  screen.note("the file holds the blows so far; go on with: " + resume_command(flags.output));
}

// Records, and writes the file.
Outcome record_file(const RecordFlags& flags, const InterruptedSession& interrupted, const UnfinishedSession& earlier,
                    pipeline::GuideOptions options) {
  const auto analysis = options.analysis;
  Recording recording = open_recording(flags, interrupted);
  auto& stream = recording.stream;
  const bool resumed = interrupted.journal != nullptr;
  if (!resumed) stream->append_event(settings_json(flags));  // at once: a kill may follow
  note_overwritten_session(earlier, flags);
  const acquire::StreamFormat format = stream->format();
  const SessionSignals signals;
  RecordTerminal terminal(STDIN_FILENO, flags.json ? STDERR_FILENO : STDOUT_FILENO, flags.quiet);
  RecordScreen screen(terminal, flags, options);
  pipeline::Guide guide(format, std::move(recording.channels), std::move(options), *stream, screen);
  screen.begin(format, guide);
  if (resumed) take_interrupted(interrupted, flags, guide, screen);
  Ending ending = record_or_name_resume(flags, *stream, guide, terminal, screen);
  if (resumed) ending.missing_frames += missing_frames(*interrupted.journal);
  const pipeline::SessionState& session = guide.session();
  if (ending.early && ending.device == StreamEnd::finished)
    screen.note("the device ended before every point had its blows");
  stream.reset();
  Outcome out{.code = ending.early ? kPartial : kOk, .accepted = session.accepted(), .document = {}};
  if (out.accepted == 0 && !ending.broken) out.code = kImpossible;
  if (session.blows().empty()) {
    screen.note("no blow was recorded, so no file is written");
    fs::remove(journal_of(flags.output));  // it holds no blow
    return out;
  }
  const acquire::Record record = guide.record();
  keep_session(flags, record, ending, screen);
  if (flags.quiet && !flags.json) return out;  // nothing would show the analysis
  const SessionResult result(record, flags.output, analysis, session.accepted());
  screen.end(guide, result);
  if (flags.json) out.document = result.document();
  return out;
}

}  // namespace

int run_record(RecordFlags flags) {
  if (flags.device == "list") return list_devices();
  flags.channels = parse_channels(flags.channel_list);
  InterruptedSession interrupted;
  if (!flags.resume.empty()) interrupted = open_interrupted(flags);
  const UnfinishedSession earlier = flags.resume.empty() ? find_unfinished(flags) : UnfinishedSession{};
  check_session_files(flags);
  if (flags.device.empty()) throw OptionError({"device"}, "is missing", "name what records; percuss devices lists it");
  if (flags.is_given("fast") && !repeats_itself(flags.device)) {
    throw OptionError({"fast"}, "is for simulated and replayed devices",
                      "leave it out, or name sim: or file:", {"device"});
  }
  if (flags.resume.empty() && !repeats_itself(flags.device)) flags.date = report::creation_time() + " UTC";
  const Outcome outcome = record_file(flags, interrupted, earlier, guide_options(flags));
  if (flags.json) std::cout << outcome.document << std::flush;
  if (flags.report.empty()) return outcome.code;
  if (outcome.accepted == 0) {
    print_note({}, {"no report is written, because no blow counts", {"report"}});
    return outcome.code;
  }
  const int reported = write_session_report(flags);
  return outcome.code == kOk ? reported : outcome.code;
}

}  // namespace percuss::tools
