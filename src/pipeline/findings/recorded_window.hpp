#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "pipeline/findings/difference_profile.hpp"

namespace percuss::pipeline {

/// The noise of one response along its time.
struct NoiseHistory {
  DifferenceProfile after;       // level after the hit
  std::optional<double> before;  // level of the same differences before the hit
};

/// A window that the recorder applied to the responses. Noise does not decay. Where it seems to, a window reduced the
/// noise and the motion alike, and damping comes out too high.
struct RecordedWindow {
  bool exponential = true;  // false: the noise falls to zero at the end as under a Hann window
  double decay_per_s = 0, decay_std_per_s = 0;
  double end_level = 0;  // noise at the end over noise before the hit, or in the middle of the record
};

/// The window that the noise of the responses shows, if any. An exponential window is found only where the noise before
/// the hit is known: windowed noise starts at this level, a decaying response above it. `hit_sample` is the sample of
/// the hit. theory (1.9)
std::optional<RecordedWindow> find_recorded_window(const std::vector<NoiseHistory>& responses, double hit_sample,
                                                   double fs_Hz);

}  // namespace percuss::pipeline
