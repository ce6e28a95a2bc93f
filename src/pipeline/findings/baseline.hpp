#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace percuss::pipeline {

inline constexpr std::size_t kRestWindows = 12;
/// Means of a response before the hit, and over kRestWindows windows after it, each a 16th of the row. The structure's
/// oscillations cancel in these means.
struct RestLevels {
  std::optional<double> before;  // nothing where too few samples are before the hit
  double noise = 0;              // standard deviation of the samples before
  std::array<double, kRestWindows> after{};
  // Samples before, first sample after, samples of each window; no window where the row is too short for all.
  std::size_t quiet = 0, first = 0, window = 0;
};
RestLevels rest_levels(std::span<const double> x, std::size_t quiet, std::size_t first);

/// Motion of a sensor's zero: a step at the hit that decays exponentially, or a slope over the whole row.
struct BaselineChange {
  bool step = true;
  double size = 0;         // of the step, or of the change over the row; m/s²
  double share = 0;        // of the largest response
  double decay_per_s = 0;  // of the step
};

inline constexpr double kMinBaselineChange = 0.02;  // of the largest response
/// Nothing where the means change by less than kMinBaselineChange or within their noise, or follow neither a step nor a
/// slope.
std::optional<BaselineChange> find_baseline_change(const RestLevels& levels, std::size_t samples, double largest,
                                                   double fs_Hz);

/// Whether a change exceeds what motion before the hit explains, such as hum: its mean there is not zero if the samples
/// before the hit are few. x begins with `quiet` samples before the hit; its end shows how large the motion is.
bool exceeds_motion_before(const BaselineChange& change, std::span<const double> x, std::size_t quiet);

/// False where a step that find_baseline_change() found in these levels is an oscillation: the swing of a structure on
/// a soft suspension, and what remains of faster oscillations in the means. A step of the zero keeps its sign: the
/// windows after those of the fit may shift the other way by 0.3 of the first window's shift at most. Where one does
/// by 0.1, windows that begin up to a quarter later must show the step too: what remains of an oscillation in a mean
/// depends on where the window begins.
/// x  the samples of the levels
bool keeps_its_sign(const RestLevels& levels, std::span<const double> x);

/// The largest mean of a sinusoid over a time: over the few samples before a hit, hum has a mean.
double largest_mean(double amplitude, double freq_Hz, double time_s);

void subtract_baseline(const BaselineChange& change, std::size_t hit_sample, double fs_Hz, std::span<double> x);

}  // namespace percuss::pipeline
