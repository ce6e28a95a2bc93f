#include "pipeline/findings/sinusoids.hpp"

#include <bit>
#include <cmath>

#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

double window_at(std::size_t n, std::size_t length) {
  const double c = std::cos(kTwoPi * (static_cast<double>(n) + 0.5) / static_cast<double>(length));
  const double twice = 2 * c * c - 1, thrice = (2 * twice - 1) * c;  // cosines of the multiples
  return 0.35875 - 0.48829 * c + 0.14128 * twice - 0.01168 * thrice;
}

}  // namespace

std::size_t segment_length(std::size_t samples) { return std::bit_floor(samples / 2); }
Segment late_segment(std::size_t samples) { return {samples - segment_length(samples), segment_length(samples)}; }
Segment early_segment(std::size_t samples) {
  return {samples - segment_length(samples) - samples / 8, segment_length(samples)};
}

std::vector<double> window_of(std::size_t length) {
  std::vector<double> window(length);
  double sum = 0;
  for (std::size_t n = 0; n < length; ++n) sum += window[n] = window_at(n, length);
  for (double& value : window) value *= 2 / sum;
  return window;
}

Complex amplitude_in(std::span<const double> x, const Segment& segment, const std::vector<double>& window,
                     double turns_per_sample) {
  const Complex step = std::polar(1.0, -kTwoPi * turns_per_sample);
  Complex sum, phase;
  for (std::size_t n = 0; n < segment.length; ++n) {
    const auto sample = static_cast<double>(segment.first + n);
    phase = n % kRestart == 0 ? std::polar(1.0, -kTwoPi * std::fmod(turns_per_sample * sample, 1.0)) : phase * step;
    sum += phase * (window[n] * x[segment.first + n]);
  }
  return sum;
}

std::vector<Complex> amplitudes_of(std::span<const ToneSignal> signals, const std::vector<double>& window,
                                   double turns) {
  std::vector<Complex> amplitude;
  for (const ToneSignal& signal : signals)
    amplitude.push_back(amplitude_in(signal.x, late_segment(signal.x.size()), window, turns));
  return amplitude;
}

double refined_turns_per_sample(std::span<const ToneSignal> signals, const std::vector<double>& window, double turns) {
  const std::size_t samples = signals.front().x.size();
  const Segment early = early_segment(samples), late = late_segment(samples);
  const auto shift = static_cast<double>(late.first - early.first);
  for (int pass = 0; pass < 2; ++pass) {
    Complex advance;
    double early_power = 0, late_power = 0;
    for (const ToneSignal& signal : signals) {
      const Complex a = amplitude_in(signal.x, early, window, turns), b = amplitude_in(signal.x, late, window, turns);
      advance += b * std::conj(a);
      early_power += std::norm(a);
      late_power += std::norm(b);
    }
    if (!(early_power > 0) || std::abs(late_power / early_power - 1) > kSteady) return 0;
    turns += std::arg(advance) / (kTwoPi * shift);
  }
  return turns;
}

}  // namespace percuss::pipeline
