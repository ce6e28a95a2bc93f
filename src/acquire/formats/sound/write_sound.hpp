#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a WAV, RF64 or W64 file by the name's ending: rows end to end with a cue at each, channels force first,
/// 64-bit floating-point numbers within −1 … 1. Full scale is a power of two of each channel's own, so that no digit is
/// lost; the chunk CAL1 holds it and everything else that the format has no place for. W64 has no chunks: its numbers
/// are N and m/s², and where rows begin is lost. errors  InputError: as SoundOutput; more than 4 GB in a WAV file.
void write_sound(const std::string& path, const Record& record, bool force);

}  // namespace percuss::acquire
