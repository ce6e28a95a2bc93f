#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <utility>

#include "acquire/live/capture_stream.hpp"
#include "acquire/live/journal_reader.hpp"
#include "acquire/live/open_device.hpp"
#include "acquire/write_record.hpp"
#include "cli/analysis_flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/option_error.hpp"
#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/record/raw_terminal.hpp"
#include "commands/record/record_flags.hpp"
#include "commands/record/record_plan.hpp"
#include "commands/record/record_result.hpp"
#include "commands/record/record_screen.hpp"
#include "commands/record/record_terminal.hpp"
#include "core/error.hpp"
#include "pipeline/live/guidance_text.hpp"
#include "pipeline/live/guide.hpp"
#include "report/text/version.hpp"
#include "synth/simulated_device.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using acquire::CaptureFault, acquire::FaultKind, acquire::StreamEnd;
using Kind = pipeline::SessionEvent::Kind;

constexpr std::size_t kReplay_frames = 8192;
constexpr double kKeptBefore_s = 1;  // of silence before the first blow, in the journal

// Only a device that makes the same samples again goes on where the session was interrupted.
bool repeats_itself(const std::string& device) { return device.starts_with("sim:") || device.starts_with("file:"); }

struct Interrupted {
  std::unique_ptr<acquire::JournalReader> journal;
  std::vector<pipeline::SessionEvent> events;
};

Interrupted open_interrupted(RecordFlags& flags) {
  const std::string path = journal_of(flags.resume);
  if (!fs::exists(path)) {
    throw InputError("no journal of an interrupted session", path,
                     fs::exists(flags.resume) ? "the session was finished: analyse the file" : "record it anew");
  }
  Interrupted out{.journal = std::make_unique<acquire::JournalReader>(path), .events = {}};
  bool settings = false;
  for (const acquire::JournalEvent& event : out.journal->events()) {
    if (is_settings(event.json)) {
      if (!std::exchange(settings, true)) restore_settings(event.json, path, flags);
    } else {
      out.events.push_back(pipeline::parse_session_event(event.json, path));
    }
  }
  if (!settings) throw InputError("the journal has no options of a session", path, "record it anew");
  flags.output = flags.resume;
  flags.force = true;
  return out;
}

std::unique_ptr<acquire::CaptureStream> open_stream(const RecordFlags& flags, const Interrupted& interrupted) {
  const bool resumed = interrupted.journal != nullptr;
  acquire::DeviceOptions device{.fs_Hz = flags.fs_Hz, .fast = flags.fast};
  acquire::CaptureOptions options{
      .journal = journal_of(flags.output), .overwrite = flags.force, .resume = resumed, .channels = {}};
  for (const std::size_t channel : flags.channels) {
    if (channel == 0) throw OptionError::wrong_value("channels", "0", "count channels from 1");
    options.channels.push_back(channel - 1);
  }
  if (resumed && repeats_itself(flags.device)) {
    device.start_frame = interrupted.journal->end_frame();
    options.seamless = true;
  }
  return std::make_unique<acquire::CaptureStream>(
      acquire::open_device(flags.device, device, synth::open_simulated_device), options);
}

void replay(const acquire::JournalReader& journal, pipeline::Guide& guide) {
  std::uint64_t end = 0;
  for (const acquire::FrameRange& range : journal.ranges()) {
    for (std::uint64_t at = 0; at < range.frames; at += kReplay_frames) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kReplay_frames, range.frames - at));
      guide.take({.first_frame = range.first + at,
                  .frames = count,
                  .values = journal.read(range.first + at, count),
                  .overrun = at == 0 && end > 0 && range.first == end});
    }
    end = range.first + range.frames;
  }
}

std::optional<FaultKind> stored_kind(CaptureFault fault) {
  switch (fault) {
    case CaptureFault::clock_drift:
      return FaultKind::clock_drift;
    case CaptureFault::unplugged:
      return FaultKind::unplugged;
    case CaptureFault::rate_changed:
      return FaultKind::rate_changed;
    case CaptureFault::failed:
      return FaultKind::failed;
    default:
      return {};  // the guide sees the others in the samples, or they are about the journal
  }
}

void take_findings(acquire::CaptureStream& stream, pipeline::Guide& guide, RecordScreen& screen) {
  for (const acquire::CaptureFinding& finding : stream.take_findings()) {
    if (const auto kind = stored_kind(finding.fault)) guide.add_fault(*kind, finding.frame, finding.value);
    if (finding.fault != CaptureFault::resumed && finding.fault != CaptureFault::overload)
      screen.note(acquire::finding_text(finding));
  }
}

void press(const PressedKey& key, pipeline::Guide& guide, RecordScreen& screen) {
  const auto& points = guide.session().plan().points;
  switch (key.key) {
    case RecordKey::pause:
      return guide.command(Kind::pause);
    case RecordKey::undo:
      return guide.command(Kind::undo);
    case RecordKey::redo:
      return guide.command(Kind::redo);
    case RecordKey::next:
      return guide.command(Kind::next);
    case RecordKey::finish:
      return guide.command(Kind::finish);
    case RecordKey::go_to:
      if (key.number >= 1 && key.number <= points.size()) return guide.command(Kind::go_to, points[key.number - 1]);
      screen.note(fmt::format("there is no point {}; points count from 1 to {}", key.number, points.size()));
  }
}

// Until the session is finished, the device ends or a signal arrives. Returns why.
StreamEnd record_blows(acquire::CaptureStream& stream, pipeline::Guide& guide, RecordTerminal& terminal,
                       RecordScreen& screen) {
  bool kept = false;
  while (!guide.session().finished() && SessionSignals::arrived() == 0) {
    while (const auto key = terminal.take_key()) press(*key, guide, screen);
    auto block = stream.next(20ms);
    if (block) guide.take(std::move(*block));
    if (!kept && (guide.collecting() || !guide.session().blows().empty())) {
      stream.keep_from(guide.frame_before_first_blow(kKeptBefore_s));
      kept = true;
    }
    take_findings(stream, guide, screen);
    screen.update(guide);
    if (!block && stream.end() != StreamEnd::none) break;
  }
  const StreamEnd end = stream.end();
  stream.stop();
  if (!guide.session().finished()) guide.finish();
  take_findings(stream, guide, screen);
  return end;
}

int exit_code_of(const pipeline::Session& session, bool ended_early) {
  if (session.accepted() == 0) return kImpossible;
  return ended_early && !session.complete() ? kPartial : kOk;
}

int list_devices() {
  CommandLine line("percuss", "", report::version());
  add_devices(line);
  constexpr std::array kWords{"percuss", "devices"};
  return line.run(static_cast<int>(kWords.size()), kWords.data());
}

void check_paths(const RecordFlags& flags) {
  if (flags.output.empty()) throw OptionError({"output"}, "is missing", "name the file to record, such as -o test.h5");
  const std::string kind = extension_of(flags.output);
  if (kind != ".h5" && kind != ".hdf5")
    throw OptionError::wrong_value("output", flags.output, "name a file that ends in .h5 or .hdf5");
  for (const std::string& path : {flags.output, flags.report}) {
    if (!path.empty() && !flags.force && fs::exists(path))
      throw InputError("file exists", path, "give another name, or overwrite it", {"force"});
  }
  if (!flags.report.empty() && !is_page(flags.report))
    throw OptionError::wrong_value("report", flags.report, "name a file that ends in .html or .pdf");
}

}  // namespace

int run_record(RecordFlags flags) {
  if (flags.device == "list") return list_devices();
  Interrupted interrupted;
  if (!flags.resume.empty()) interrupted = open_interrupted(flags);
  check_paths(flags);
  if (flags.device.empty()) throw OptionError({"device"}, "is missing", "name what records; percuss devices lists it");
  pipeline::GuideOptions options = guide_options(flags);
  const auto analysis = options.analysis;
  auto stream = open_stream(flags, interrupted);
  if (interrupted.journal == nullptr) stream->append_event(settings_json(flags));  // at once: a kill may follow
  const acquire::StreamFormat format = stream->format();
  pipeline::LiveChannels channels = pipeline::live_channels(format, resolved_read_options(flags.read));
  int code = kOk;
  std::string document;
  {
    const SessionSignals signals;
    RecordTerminal terminal(STDIN_FILENO, flags.json ? STDERR_FILENO : STDOUT_FILENO, flags.quiet);
    RecordScreen screen(terminal, flags, options);
    pipeline::Guide guide(format, std::move(channels), std::move(options), *stream, screen);
    screen.begin(format, guide);
    if (interrupted.journal != nullptr) {
      guide.resume_from(interrupted.events);
      replay(*interrupted.journal, guide);
      screen.resumed(guide);
    }
    const StreamEnd end = record_blows(*stream, guide, terminal, screen);
    const bool device_failed =
        end == StreamEnd::unplugged || end == StreamEnd::rate_changed || end == StreamEnd::failed;
    code = exit_code_of(guide.session(), device_failed || end == StreamEnd::finished || SessionSignals::arrived() != 0);
    if (end == StreamEnd::finished && !guide.session().complete() && !guide.session().finished())
      screen.note("the device ended before every point had its blows");
    stream.reset();
    if (guide.session().blows().empty()) {
      screen.note("no blow was recorded, so no file is written");
      if (!device_failed) fs::remove(journal_of(flags.output));
      return kImpossible;
    }
    const acquire::Record record = guide.record();
    acquire::write_record(flags.output, record, flags.force);
    if (device_failed) {
      screen.note(fmt::format("the file holds the blows so far; go on with: percuss record --resume {}", flags.output));
    } else {
      fs::remove(journal_of(flags.output));  // the file is whole, and on the disk
    }
    screen.end(guide, record, analysis);
    if (flags.json) document = session_document(record, flags.output, analysis);
  }
  if (!flags.report.empty() && code != kImpossible) write_session_report(flags);
  if (flags.json) std::cout << document << std::flush;
  return code;
}

}  // namespace percuss::tools
