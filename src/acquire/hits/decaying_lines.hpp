#pragma once
#include <cstddef>

#include "acquire/hits/response_grade.hpp"

namespace percuss::acquire {

/// A frequency band over the sampling rate, 0 < low < high <= 1/2.
struct RelativeBand {
  double low = 0, high = 0;
};

/// Whether a spectral line of the band still decays after the first `length` of the `samples` of a hit: its power there
/// exceeds its noise, and 1.5 times its power at the end of the samples. Noise and steady sinusoids, such as hum of the
/// mains, do not decay. Also true if the samples after `length` are too few to tell: if two segments of at least eight
/// periods of the lower end of the band have no room. Reads one segment around `length` and one at the end.
bool has_decaying_lines(std::size_t length, std::size_t samples, const RelativeBand& band,
                        const SampleWindow& accel_mps2);

}  // namespace percuss::acquire
