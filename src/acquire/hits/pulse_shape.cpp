#include "acquire/hits/pulse_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/math/fft.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kPulseEdge = 0.05;   // of the peak: above the ringing of a brick-wall filter, below any pulse's flank
constexpr std::size_t kRinging = 72;  // samples: twice the length of the filters of delta-sigma converters down to 1e-8
constexpr double kGateNoise = 4;      // standard deviations
constexpr std::size_t kGateGap = 8;   // samples without ringing that end the gate
constexpr double kGateFloor = 1e-9;   // of the peak
constexpr double kSecondNoise = 6;    // standard deviations of the smoothed force
constexpr double kSecondFraction = 0.005;  // of the peak; smaller pulses change an FRF by at most 0.04 dB
constexpr std::size_t kMinPadded = 2048;   // samples
constexpr std::size_t kPadding = 8;        // times the pulse length: the spectrum is nearly straight between lines
constexpr double kBandwidthDrop = 0.1;     // −20 dB

// The fractional sample where |x| crosses `level` between samples i and i + 1.
double crossing(double a, double b, double level, double i) { return b == a ? i : i + (level - a) / (b - a); }

std::size_t max_of_signed(std::span<const double> x, double sign, std::size_t begin, std::size_t end) {
  std::size_t best = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (sign * x[i] > sign * x[best]) best = i;
  }
  return best;
}

// Running mean over 2h + 1 samples. It reduces the noise and the ringing near fs/2. Pulses as long as the main pulse
// remain.
std::vector<double> smoothed(std::span<const double> x, double sign, std::size_t h) {
  std::vector<double> out(x.size());
  const double share = 1 / static_cast<double>(2 * h + 1);
  double sum = 0;
  for (std::size_t i = 0; i < std::min(h, x.size()); ++i) sum += sign * x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i + h < x.size()) sum += sign * x[i + h];
    if (i > h) sum -= sign * x[i - h - 1];
    if (i >= h && i + h < x.size()) {
      out[i] = sum * share;
    } else {
      const std::size_t count = std::min(i + h, x.size() - 1) - (i > h ? i - h : 0) + 1;
      out[i] = sum / static_cast<double>(count);
    }
  }
  return out;
}

// The largest mean over 2h + 1 samples within the pulse.
double smoothed_peak(std::span<const double> x, double sign, const PulseShape& pulse, std::size_t h) {
  const auto rise = static_cast<std::size_t>(std::max(0.0, pulse.rise));
  const std::size_t end = std::min(x.size(), static_cast<std::size_t>(pulse.fall) + 1);
  const auto means = smoothed(x.subspan(rise, end - rise), sign, h);
  return *std::max_element(means.begin(), means.end());
}

// The highest sample at least `guard` samples outside the crossings of the pulse, and at least 0.
double highest_outside(std::span<const double> x, double sign, const PulseShape& pulse, double guard) {
  const auto highest = [&](std::span<const double> part) {
    const Extremes extremes = extremes_of(part);
    return sign > 0 ? extremes.high : -extremes.low;
  };
  const auto before = static_cast<std::size_t>(std::max(0.0, pulse.rise - guard));
  const auto after = std::min(x.size(), static_cast<std::size_t>(pulse.fall + guard));
  return std::max(highest(x.first(before)), highest(x.subspan(after)));
}

// The ringing of a filter alternates in sign; a pulse does not.
bool looks_like_ringing(std::span<const double> x, std::size_t i) {
  constexpr std::size_t kNear = 3;
  const std::size_t first = i > kNear ? i - kNear : 0;
  const auto around = x.subspan(first, std::min(i + kNear + 1, x.size()) - first);
  return -*std::min_element(around.begin(), around.end()) > 0.5 * x[i];
}

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

Gate gate_around(std::span<const double> force_N, const PulseShape& pulse, double noise_N) {
  const double level = std::max(kGateNoise * noise_N, kGateFloor * std::abs(force_N[pulse.peak]));
  const auto rise = static_cast<std::size_t>(std::max(0.0, std::floor(pulse.rise)));
  const auto fall = std::min(static_cast<std::size_t>(std::ceil(pulse.fall)), force_N.size() - 1);
  Gate gate{.first = rise, .end = fall + 1};
  // The gate grows sample by sample. A high sample far outside is noise, and the gate would contain all noise up to it.
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

std::optional<SecondPulse> second_pulse(std::span<const double> force_N, const PulseShape& pulse, double noise_N) {
  const double sign = force_N[pulse.peak] < 0 ? -1 : 1;
  const double width = std::max(1.0, pulse.fall - pulse.rise);
  const auto half = static_cast<std::size_t>(width / 4);
  const double noise = noise_N / std::sqrt(static_cast<double>(2 * half + 1));
  const double guard = std::max(width, 8.0);
  const auto threshold_beside = [&](double main) { return std::max(kSecondNoise * noise, kSecondFraction * main); };
  if (highest_outside(force_N, sign, pulse, guard) < threshold_beside(smoothed_peak(force_N, sign, pulse, half)))
    return std::nullopt;  // no running mean can exceed the threshold
  const auto x = smoothed(force_N, sign, half);
  const double main = *std::max_element(x.begin(), x.end());
  const double threshold = threshold_beside(main);

  // The height of a second pulse counts from the lowest point between the two pulses.
  SecondPulse best;
  const auto scan = [&](std::size_t begin, std::size_t end, bool forward) {
    double valley = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n + begin < end; ++n) {
      const std::size_t i = forward ? begin + n : end - 1 - n;
      valley = std::min(valley, x[i]);
      const double rise = x[i] - std::max(valley, 0.0);
      if (rise < threshold || rise < 0.5 * x[i] || rise / main <= best.ratio) continue;
      if (half == 0 && looks_like_ringing(x, i)) continue;  // the pulse is too short to average
      best = {.delay_samples = static_cast<double>(i) - static_cast<double>(pulse.peak), .ratio = rise / main};
    }
  };
  const double after = pulse.fall + guard;
  if (after < static_cast<double>(x.size())) scan(static_cast<std::size_t>(after), x.size(), true);
  if (pulse.rise > guard) scan(0, static_cast<std::size_t>(pulse.rise - guard), false);
  if (best.ratio <= 0) return std::nullopt;
  // The delay is between the peaks of the force, not of the smoothed force.
  const auto near = static_cast<std::size_t>(static_cast<double>(pulse.peak) + best.delay_samples);
  const std::size_t reach = 2 * half + 1;
  const std::size_t peak =
      max_of_signed(force_N, sign, near > reach ? near - reach : 0, std::min(near + reach + 1, x.size()));
  best.delay_samples = static_cast<double>(peak) - static_cast<double>(pulse.peak);
  return best;
}

void plan_bandwidths() { plan_real_dft(kMinPadded); }

double bandwidth_Hz(std::span<const double> pulse, double fs_Hz) {
  // A power of two: every other length would need its own plan.
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
