#pragma once
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::stress {

/// A record's samples, to be spoilt in ways that no spec describes.
struct Samples {
  double fs_Hz = 0;
  std::vector<std::vector<double>> force_N;                  // [row][sample]
  std::vector<std::vector<std::vector<double>>> accel_mps2;  // [row][channel][sample]
};

Samples samples_of(const acquire::Record& record);
/// As `like` describes it, with these samples.
acquire::Record record_of(Samples samples, const acquire::Record& like);

void scale(Samples& samples, double force, double accel);
/// The first `count` samples of every row.
void cut(Samples& samples, std::size_t count);
/// What a file of single-precision numbers keeps.
void round_to_float(Samples& samples);
/// The hammer's cable in the first accelerometer's socket and the other way round.
void swap_force_and_first_accel(Samples& samples);
/// Mains hum and its odd harmonics up to the fifth, each `part` of the largest acceleration, in step with nothing.
void add_hum(Samples& samples, double mains_Hz, double part);

}  // namespace percuss::stress
