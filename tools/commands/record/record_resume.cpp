#include "commands/record/record_resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

#include "acquire/formats/hdf5/read_hdf5.hpp"
#include "acquire/open_measurement.hpp"
#include "cli/option_error.hpp"
#include "commands/record/record_paths.hpp"
#include "core/error.hpp"

namespace percuss::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReplay_frames = 8192;

void replay_samples(const acquire::JournalReader& journal, pipeline::Guide& guide) {
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

std::vector<acquire::RowInfo> rows_of(const std::string& path) {
  if (acquire::is_hdf5(path)) {
    try {
      return acquire::open_record(path, {.sandboxed = true}).rows;
    } catch (const InputError&) {
    }
  }
  std::vector<OptionId> options;
  if (!fs::is_directory(path)) options.emplace_back("force");
  throw InputError("the file is no record of the session", path, "move it elsewhere, and resume again", options);
}

// The first frame whose samples the journal has.
std::uint64_t first_frame_of(const acquire::JournalReader& journal) {
  const auto& ranges = journal.ranges();
  return ranges.empty() ? std::numeric_limits<std::uint64_t>::max() : ranges.front().first;
}

// The end of a resumed session overwrites the file. Refuses a file with more blows than the journal: the journal may be
// damaged. One more row is allowed if the end of the device cut it short.
void refuse_loss(const std::string& path, const InterruptedSession& interrupted, bool overwrite) {
  if (!fs::exists(path) || (overwrite && !acquire::is_hdf5(path))) return;
  const std::vector<acquire::RowInfo> rows = rows_of(path);
  const std::size_t blows = blow_count(interrupted.events, first_frame_of(*interrupted.journal));
  const bool cut_short = !rows.empty() && rows.back().mark == acquire::RowMark::ended;
  if (rows.size() <= blows + (cut_short ? 1 : 0)) return;
  throw InputError(fmt::format("the file holds {} blows, its journal {}", rows.size(), blows), path,
                   "keep the file: move it elsewhere, and resume again");
}

// --resume also takes the journal: after a kill, it is the only file of the session, so a shell completes its name.
void take_journal_as_output(std::string& path) {
  const std::string suffix = journal_of("");
  if (path.ends_with(suffix)) path.resize(path.size() - suffix.size());
}

}  // namespace

std::vector<pipeline::SessionEvent> session_events(const acquire::JournalReader& journal) {
  std::vector<pipeline::SessionEvent> events;
  for (const acquire::JournalEvent& event : journal.events()) {
    if (!is_settings(event.json)) events.push_back(pipeline::parse_session_event(event.json, journal.path()));
  }
  return events;
}

std::size_t blow_count(const std::vector<pipeline::SessionEvent>& events, std::uint64_t first_frame) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(), [&](const auto& event) {
    return event.kind == pipeline::SessionEvent::Kind::blow && event.frame >= first_frame;
  }));
}

InterruptedSession open_interrupted(RecordFlags& flags) {
  take_journal_as_output(flags.resume);
  if (flags.is_given("output") && !names_same_file(flags.output, flags.resume))
    throw OptionError({"output", "resume"}, "name different files", "leave --output out");
  const std::string path = journal_of(flags.resume);
  if (!fs::exists(path)) {
    throw InputError("no journal of an interrupted session", path,
                     fs::exists(flags.resume) ? "the session was finished: analyse the file" : "record it anew");
  }
  InterruptedSession out{.journal = std::make_unique<acquire::JournalReader>(path), .events = {}};
  const auto& events = out.journal->events();
  const auto settings = std::find_if(events.begin(), events.end(),
                                     [](const acquire::JournalEvent& event) { return is_settings(event.json); });
  if (settings == events.end()) throw InputError("the journal has no options of a session", path, "record it anew");
  restore_settings(settings->json, path, flags);
  out.events = session_events(*out.journal);
  refuse_loss(flags.resume, out, flags.is_given("force"));
  flags.output = flags.resume;
  flags.force = true;
  return out;
}

std::string torn_text(const InterruptedSession& interrupted) {
  const std::uint64_t bytes = interrupted.journal->torn_bytes();
  return bytes == 0 ? "" : fmt::format("the last {} bytes of the journal are not whole and are left out", bytes);
}

std::uint64_t missing_frames(const acquire::JournalReader& journal) {
  std::uint64_t frames = 0;
  for (const acquire::CaptureFinding& finding : journal.findings())
    frames += finding.fault == acquire::CaptureFault::not_in_journal ? finding.count : 0;
  return frames;
}

std::string missing_text(std::uint64_t frames, double fs_Hz) {
  return fmt::format(
      "{} frames ({:.2g} s) are not in the journal, because it could not be written: a resumed session "
      "lacks the blows among them",
      frames, static_cast<double>(frames) / fs_Hz);
}

bool repeats_itself(const std::string& device) { return device.starts_with("sim:") || device.starts_with("file:"); }

void replay(const InterruptedSession& interrupted, bool seamless, pipeline::Guide& guide) {
  const acquire::JournalReader& journal = *interrupted.journal;
  guide.resume_from(interrupted.events, journal.findings(), first_frame_of(journal));
  replay_samples(journal, guide);
  if (!seamless && journal.frames() > 0)
    guide.add_finding({.fault = acquire::CaptureFault::resumed, .frame = journal.end_frame()});
}

}  // namespace percuss::tools
