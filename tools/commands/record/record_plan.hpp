#pragma once
#include "commands/record/record_flags.hpp"
#include "pipeline/live/guide.hpp"

namespace percuss::tools {

/// The guide's options: points from the geometry file, the band, goals, and the folder of the output.
/// errors  InputError, UsageError: unusable files or values.
pipeline::GuideOptions guide_options(const RecordFlags& flags);

}  // namespace percuss::tools
