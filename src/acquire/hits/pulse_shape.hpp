#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::acquire {

/// The main pulse of a force signal, baseline removed.
struct PulseShape {
  std::size_t peak = 0;       // sample
  double rise = 0, fall = 0;  // crossings of 5 % of the peak, in samples (interpolated)
  bool has_rise = true;       // false: the signal begins above 5 % of the peak
};

/// Crossings of 5 % of the value at `peak` on either side of it.
/// theory (1.3)
PulseShape shape_of_pulse(std::span<const double> force_N, std::size_t peak);
/// Samples from the first crossing to the peak, rounded up.
std::size_t rise_samples(const PulseShape& pulse);

/// No hammer tip makes a longer pulse: longer is drift. At low rates a pulse may last kLongestPulse_samples samples.
inline constexpr double kLongestPulse_s = 0.05;
inline constexpr std::size_t kLongestPulse_samples = 8;
/// The smallest peak of a blow, over the standard deviation of the noise.
inline constexpr double kPulseToNoise = 10;
/// Whether the force around `peak` is a blow: above ten times its noise, and no longer than a hammer's contact.
bool is_hammer_pulse(std::span<const double> force_N, std::size_t peak, double noise_N, double fs_Hz);

/// The gate [first, end) holds the pulse and the ringing of the recorder's anti-alias filter. It extends to the last
/// sample within 72 of the crossings that exceeds 4 standard deviations of the noise and 1e-9 of the peak. Eight
/// successive samples at or below this level end the gate. theory (1.4)
struct Gate {
  std::size_t first = 0, end = 0;
};
Gate gate_around(std::span<const double> force_N, const PulseShape& pulse, double noise_N);

/// Frequency at which the amplitude spectrum of a pulse first falls 20 dB below its largest line; half the sampling
/// rate if it does not.
/// theory (1.5)
double bandwidth_Hz(std::span<const double> pulse, double fs_Hz);
/// Plans the transforms of common pulse lengths. Call it before a parallel loop, so that threads do not wait for plans.
void plan_bandwidths();

}  // namespace percuss::acquire
