#pragma once
#include "commands/record/record_flags.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::tools {

/// The guide's options from the flags, with the points of the geometry file and the folder of the output.
/// errors  InputError, UsageError: unusable files or values.
pipeline::GuideOptions guide_options(const RecordFlags& flags);

/// Refuses a sampling rate below 100 Hz, a band that the rate cannot hold, a pre-trigger without a sample, and a length
/// shorter than two pre-triggers.
/// errors  InputError
void check_recording(const acquire::Record& description, const RecordFlags& flags);

}  // namespace percuss::tools
