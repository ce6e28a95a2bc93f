#pragma once
#include "commands/record/record_flags.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::tools {

/// The guide's options: points from the geometry file, the band, goals, and the folder of the output.
/// errors  InputError, UsageError: unusable files or values.
pipeline::GuideOptions guide_options(const RecordFlags& flags);

/// Refuses a length without room for a pulse, and a band that the sampling rate cannot hold.
/// errors  InputError
void check_window(const acquire::Record& description, const RecordFlags& flags);

}  // namespace percuss::tools
