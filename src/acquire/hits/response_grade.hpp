#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "acquire/hits/hits.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {

/// What one acceleration channel shows of one hit.
struct ResponseGrade {
  double end_level_dB = 0;          // level at the stretch's end, below that just after the hit
  bool truncated = false;           // … and it is ringing, not noise
  std::size_t clipped_samples = 0;  // at the recorder's rail
  Extremes extremes;                // of the samples, m/s²
  double resolution = 0;            // smallest change from sample to sample, m/s²
  bool rings_before = false;        // the pre-trigger is not at rest
  bool dead = false;                // every sample is the same
  double coarse_step = 0;           // the recorder's, over the largest response; 0: fine, or blurred by noise
  std::optional<double> delay_s;    // from the force's onset to the response's, not negative; resolution one sample
  int polarity = 0;                 // sign of the first motion; 0: not seen, or too uneven to tell
};

/// Grades one channel's samples, which begin at the hit's first one.
ResponseGrade grade_response(const Hit& hit, std::span<const double> accel_mps2, double fs_Hz);

/// Samples first … first + count − 1 of a hit's response.
using SampleWindow = std::function<std::span<const double>(std::size_t first, std::size_t count)>;

/// Where a response of so many samples has sunk into a steady background: the number of samples from the stretch's
/// beginning to twice the time after the hit after which it stays within twice its final level. The whole length when
/// it is still falling at the end, or has fallen too little to tell ringing from a background that the pre-trigger does
/// not show. What lies beyond holds background alone. Looks at a 64th of the stretch at a time.
std::size_t decayed_length(const Hit& hit, std::size_t samples, const SampleWindow& accel_mps2);

/// Adds `truncated_decay` and `overload` for the worst channel to the hit's findings.
void add_response_findings(Hit& hit, const std::vector<ResponseGrade>& channels);

}  // namespace percuss::acquire
