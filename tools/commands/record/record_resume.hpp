#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "acquire/live/journal_reader.hpp"
#include "commands/record/record_flags.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::tools {

/// An interrupted session. `journal` is null if no session is resumed.
struct InterruptedSession {
  std::unique_ptr<acquire::JournalReader> journal;
  std::vector<pipeline::SessionEvent> events;
};

/// The events of the guidance in a journal.
/// errors  InputError: a damaged event
std::vector<pipeline::SessionEvent> session_events(const acquire::JournalReader& journal);
/// The blows among the events whose samples begin at this frame or later.
std::size_t blow_count(const std::vector<pipeline::SessionEvent>& events, std::uint64_t first_frame = 0);

/// Opens the session that was recording the file of --resume, and takes over its options. The journal may be named in
/// place of the file. errors  InputError: no journal, or a damaged one; the file exists and is no record of the
/// session, or holds more blows than the journal; OptionError: an option contradicts the session
InterruptedSession open_interrupted(RecordFlags& flags);

/// A sentence about the bytes after the last whole block of the journal; empty if there are none.
std::string torn_text(const InterruptedSession& interrupted);

/// The frames that were analysed, but could not be written to the journal.
std::uint64_t missing_frames(const acquire::JournalReader& journal);
/// A sentence about these frames.
std::string missing_text(std::uint64_t frames, double fs_Hz);

/// Whether the device makes the same samples again. Only such a device goes on where the session was interrupted.
bool repeats_itself(const std::string& device);

/// Gives the guide the samples, verdicts, keys and faults of the session.
/// seamless  the device goes on where the session was interrupted; otherwise the guide gets a finding about the gap
void replay(const InterruptedSession& interrupted, bool seamless, pipeline::Guide& guide);

}  // namespace percuss::tools
