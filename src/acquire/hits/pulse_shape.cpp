#include "acquire/hits/pulse_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kPulseEdge = 0.05;  // of the peak: above the ringing of a brick-wall filter, below any pulse's flank
// In samples: twice the length of a delta-sigma converter's filter, whose ends are 1e-8 of its peak.
constexpr std::size_t kRinging = 72;
constexpr double kGateNoise = 4;          // standard deviations
constexpr std::size_t kGateGap = 8;       // samples without ringing that end the gate
constexpr double kGateFloor = 1e-9;       // of the peak
constexpr std::size_t kMinPadded = 2048;  // samples
constexpr std::size_t kPadding = 8;       // times the pulse length: the spectrum is nearly straight between lines
constexpr double kBandwidthDrop = 0.1;    // −20 dB

// The fractional sample where |x| crosses `level` between samples i and i + 1.
double crossing(double a, double b, double level, double i) { return b == a ? i : i + (level - a) / (b - a); }

}  // namespace

PulseShape shape_of_pulse(std::span<const double> force_N, std::size_t peak) {
  PulseShape pulse{.peak = peak, .rise = static_cast<double>(peak), .fall = static_cast<double>(peak)};
  const double sign = force_N[peak] < 0 ? -1 : 1;
  const double level = kPulseEdge * std::abs(force_N[peak]);
  std::size_t i = peak;
  while (i > 0 && sign * force_N[i - 1] >= level) --i;
  pulse.has_rise = i > 0;
  pulse.rise = i == 0 ? 0 : crossing(sign * force_N[i - 1], sign * force_N[i], level, static_cast<double>(i - 1));
  i = peak;
  while (i + 1 < force_N.size() && sign * force_N[i + 1] >= level) ++i;
  pulse.fall = i + 1 == force_N.size()
                   ? static_cast<double>(i)
                   : crossing(sign * force_N[i], sign * force_N[i + 1], level, static_cast<double>(i));
  return pulse;
}

std::size_t rise_samples(const PulseShape& pulse) {
  return static_cast<std::size_t>(std::ceil(static_cast<double>(pulse.peak) - pulse.rise));
}

bool is_hammer_pulse(std::span<const double> force_N, std::size_t peak, double noise_N, double fs_Hz) {
  if (!(std::abs(force_N[peak]) > kPulseToNoise * noise_N)) return false;
  const PulseShape pulse = shape_of_pulse(force_N, peak);
  return pulse.fall - pulse.rise <= std::max(kLongestPulse_s * fs_Hz, static_cast<double>(kLongestPulse_samples));
}

Gate gate_around(std::span<const double> force_N, const PulseShape& pulse, double noise_N) {
  const double level = std::max(kGateNoise * noise_N, kGateFloor * std::abs(force_N[pulse.peak]));
  const auto rise = static_cast<std::size_t>(std::max(0.0, std::floor(pulse.rise)));
  const auto fall = std::min(static_cast<std::size_t>(std::ceil(pulse.fall)), force_N.size() - 1);
  Gate gate{.first = rise, .end = fall + 1};
  // The gate grows sample by sample and ends at a gap. A high sample beyond the gap is noise; a gate that reached it
  // would also contain the noise in between.
  const std::size_t first = rise > kRinging ? rise - kRinging : 0;
  for (std::size_t i = rise; i > first && gate.first - i < kGateGap; --i) {
    if (std::abs(force_N[i - 1]) > level) gate.first = i - 1;
  }
  const std::size_t end = std::min(fall + kRinging + 1, force_N.size());
  for (std::size_t i = fall + 1; i < end && i - gate.end < kGateGap; ++i) {
    if (std::abs(force_N[i]) > level) gate.end = i + 1;
  }
  return gate;
}

void plan_bandwidths() { plan_real_dft(kMinPadded); }

double bandwidth_Hz(std::span<const double> pulse, double fs_Hz) {
  // A power of two, so that pulses of different lengths use the same few plans.
  std::vector<double> padded(std::bit_ceil(std::max(kMinPadded, kPadding * pulse.size())));
  std::copy(pulse.begin(), pulse.end(), padded.begin());
  const auto spectrum = real_dft_in_scratch(padded);
  double largest = 0;  // as power
  for (const Complex& line : spectrum) largest = std::max(largest, std::norm(line));
  // The first crossing: beyond the first zero of the spectrum, the side lobes do not excite evenly.
  const double level = kBandwidthDrop * std::sqrt(largest);
  std::size_t top = 0;
  while (top + 1 < spectrum.size() && std::norm(spectrum[top]) < largest) ++top;
  while (top + 1 < spectrum.size() && std::norm(spectrum[top]) > level * level) ++top;
  const bool reached = top > 0 && std::norm(spectrum[top]) <= level * level;
  const double line =
      reached ? crossing(std::abs(spectrum[top - 1]), std::abs(spectrum[top]), level, static_cast<double>(top - 1))
              : static_cast<double>(top);
  return line * fs_Hz / static_cast<double>(padded.size());
}

}  // namespace percuss::acquire
