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

/// What the recorder's channels can hold; infinite where it does not clip, step 0 where it does not quantise.
struct RecorderRange {
  double force_limit_N, accel_limit_mps2;
  double force_step_N, accel_step_mps2;
};

/// The range for a run of clean signals.
RecorderRange recorder_range(const SynthRecorder& recorder, const SynthSamples& clean);

/// Row `row` (of the whole test, for its own noise) through the recorder, in place: noise, bias and drift, clipping,
/// steps.
void record_row(const Truth& truth, const RecorderRange& range, std::size_t row, std::vector<double>& force_N,
                std::vector<std::vector<double>>& accel_mps2);

/// Flags good hits whose stretch (to the next hit of the row or the row's end) touches the recorder's limits as
/// "clipped".
void flag_clipped(const RecorderRange& range, const SynthSamples& recorded, double fs_Hz, std::vector<TrueHit>& hits);

}  // namespace percuss::synth
