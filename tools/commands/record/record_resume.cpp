#include "commands/record/record_resume.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

#include "cli/option_error.hpp"
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

}  // namespace

Interrupted open_interrupted(RecordFlags& flags) {
  if (flags.is_given("output") && flags.output != flags.resume)
    throw OptionError({"output", "resume"}, "name different files", "leave --output out");
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

bool repeats_itself(const std::string& device) { return device.starts_with("sim:") || device.starts_with("file:"); }

void replay(const Interrupted& interrupted, bool seamless, pipeline::Guide& guide) {
  const acquire::JournalReader& journal = *interrupted.journal;
  const auto& ranges = journal.ranges();
  guide.resume_from(interrupted.events, journal.findings(),
                    ranges.empty() ? std::numeric_limits<std::uint64_t>::max() : ranges.front().first);
  replay_samples(journal, guide);
  if (!seamless && !ranges.empty())
    guide.add_finding({.fault = acquire::CaptureFault::resumed, .frame = journal.end_frame()});
}

}  // namespace percuss::tools
