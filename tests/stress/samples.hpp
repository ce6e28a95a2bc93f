#pragma once
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::stress {

/// The samples of a record, for faults that no spec describes.
struct Samples {
  double fs_Hz = 0;
  std::vector<std::vector<double>> force_N;                  // [row][sample]
  std::vector<std::vector<std::vector<double>>> accel_mps2;  // [row][channel][sample]
};

Samples samples_of(const acquire::Record& record);
/// A record with the description of `like` and these samples.
acquire::Record record_of(Samples samples, const acquire::Record& like);

/// Multiplies all forces by `force`, and all accelerations by `accel`.
void scale(Samples& samples, double force, double accel);
/// Keeps the first `count` samples of every row.
void cut(Samples& samples, std::size_t count);
/// Rounds to single precision.
void round_to_float(Samples& samples);
/// Exchanges the cables of the hammer and the first accelerometer.
void swap_force_and_first_accel(Samples& samples);
/// Adds mains hum and its odd harmonics up to the fifth, each `fraction` of the largest acceleration. Each row has its
/// own phase.
void add_hum(Samples& samples, double mains_Hz, double fraction);

}  // namespace percuss::stress
