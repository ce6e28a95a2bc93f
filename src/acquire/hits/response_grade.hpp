#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {

/// The quality of one acceleration channel at one hit.
struct ResponseGrade {
  double end_level_dB = 0;          // level at the end, relative to the level just after the hit
  bool truncated = false;           // the end still rings above the noise
  std::size_t clipped_samples = 0;  // at the recorder's limit
  Extremes extremes;                // of the samples, m/s²
  double resolution = 0;            // smallest change from sample to sample, m/s²
  bool rings_before = false;        // the response rings before the hit
  bool may_ring_before = false;     // it moves before the hit: it rings, or there is hum
  bool dead = false;                // all samples are equal
  double coarse_step = 0;           // resolution over the largest response; 0: fine, or hidden by noise
  std::optional<double> delay_s;    // from force onset to response onset, not negative, to one sample
  int polarity = 0;                 // sign of the first motion; 0: unknown, or a larger motion the other way follows it
};

/// Grades the samples of one channel, which begin at the first sample of the hit.
ResponseGrade grade_response(const Hit& hit, std::span<const double> accel_mps2, double fs_Hz);

/// The part of a grade that tells of clipping: extremes, resolution, dead and clipped_samples. The first `quiet`
/// samples precede the impact.
ResponseGrade grade_clipping(std::span<const double> accel_mps2, std::size_t quiet);

/// Samples first … first + count − 1 of a hit's response.
using SampleWindow = std::function<std::span<const double>(std::size_t first, std::size_t count)>;

/// The number of samples after which a response holds only a steady background. The settling time is the time from the
/// pulse until the response stays within twice its final level. The number covers the pulse and twice the settling time
/// after it. It is all `samples` in three cases:
///   fewer than 512 samples follow the pulse, or the final level is zero;
///   the response still falls at the end;
///   the response falls only a little, and the level before the hit is unknown or at most half of the final level, so
///   that the end may be ringing.
/// Reads the samples before the pulse at once, and those after it in 64 parts.
std::size_t decayed_length(const Hit& hit, std::size_t samples, const SampleWindow& accel_mps2);

/// Adds `truncated_decay` and `overload` of the worst channel to the findings of the hit.
void add_response_findings(Hit& hit, const std::vector<ResponseGrade>& channels);

}  // namespace percuss::acquire
