#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// The record in a WAV, RF64 or W64 file. What its chunk CAL1 says of channels, hits and units holds; without one it is
/// one recording in which hits are searched, of channels called "channel 1" …, whose numbers are parts of full scale.
/// errors  InputError: as SoundInput, a chunk CAL1 that does not fit the samples; AmbiguousColumns: nothing says which
/// channel is the force.
Record open_sound(const std::string& path, const ReadOptions& options = {});

}  // namespace percuss::acquire
