#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The record in a WAV, RF64 or W64 file. Its chunk CAL1 states channels, hits and units. Without the chunk the file is
/// one recording to be searched for hits; its channels are called "channel 1" …, and its whole numbers become
/// fractions of full scale; floating-point numbers are as stored.
/// errors  InputError: as SoundInput, a chunk CAL1 that does not fit the samples; AmbiguousColumns: no channel is
/// recognisable as the force.
Record open_sound(const std::string& path, const ReadOptions& options = {});

}  // namespace percuss::acquire
