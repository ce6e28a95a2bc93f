#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "synth/synthesise.hpp"

namespace percuss::synth {

/// Every sample of a test: force [row][sample] in N, accel [row][channel][sample] in m/s².
struct SynthSamples {
  std::vector<std::vector<double>> force_N;
  std::vector<std::vector<std::vector<double>>> accel_mps2;
};

/// The range of the recorder's channels. With quantisation, the full scale limits a channel too. A limit is infinite
/// with neither clipping nor quantisation; a step is 0 without quantisation.
struct RecorderRange {
  double force_limit_N, accel_limit_mps2;
  double force_step_N, accel_step_mps2;
};

/// The range of the recorder for one run. An automatic full scale is 1.5 times the sum of the bias and the largest
/// value of `clean`, the signals without noise.
RecorderRange recorder_range(const SynthRecorder& recorder, const SynthSamples& clean);

/// Records one row in place: adds noise, bias and drift, then clips and quantises. `row` counts over the whole test and
/// selects the noise.
void record_row(const Truth& truth, const RecorderRange& range, std::size_t row, std::vector<double>& force_N,
                std::vector<std::vector<double>>& accel_mps2);

/// Flags a good hit as "clipped" if the signal reaches the recorder's limits before the next hit or the end of the row.
void flag_clipped(const RecorderRange& range, const SynthSamples& recorded, double fs_Hz, std::vector<TrueHit>& hits);

}  // namespace percuss::synth
