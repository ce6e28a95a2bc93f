#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a WAV, RF64 or W64 file; the name's ending selects the format. Rows follow one another, with a cue at the
/// start of each. The force, if recorded, is the first channel. Numbers are 64-bit floating point within −1 … 1. Each
/// channel's full scale is a power of two, so that no digit is lost. The chunk CAL1 holds the full scales and the data
/// that SoundCalibration lists; record_losses() names the data that are lost. W64 has no such chunk: its numbers are N,
/// m/s² or Pa, and the starts of rows are lost.
/// errors  InputError: as SoundOutput; more than 4 GB in a WAV file.
void write_sound(const std::string& path, const Record& record, bool overwrite);

}  // namespace percuss::acquire
