#pragma once
#include <memory>

#include "acquire/live/capture_stream.hpp"
#include "commands/record/record_flags.hpp"
#include "commands/record/record_resume.hpp"
#include "pipeline/live/live_channels.hpp"

namespace percuss::tools {

/// A running capture with its journal.
struct Recording {
  std::unique_ptr<acquire::CaptureStream> stream;
  pipeline::LiveChannels channels;
};

/// Opens the device and begins the journal, or goes on with the journal of an interrupted session. Set-up, length and
/// band are checked against the device before there is a journal.
/// errors  OptionError: a description of a pipe that is not understood; InputError: as CaptureStream, live_channels and
/// check_recording
Recording open_recording(const RecordFlags& flags, const InterruptedSession& interrupted);

}  // namespace percuss::tools
