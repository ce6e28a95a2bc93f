#pragma once
#include <span>
#include <vector>

#include "core/math/fft.hpp"
#include "pipeline/findings/tones.hpp"

namespace percuss::pipeline {

/// Largest change of the power of a tone from the early to the late segment.
inline constexpr double kSteady = 0.2;
/// Samples after which a sinusoid's phase is computed anew: rounding errors of a repeated product add up.
inline constexpr std::size_t kRestart = 256;

/// A quarter to half of a row, from `first` on. The length is a power of two, for which a transform is planned fast.
struct Segment {
  std::size_t first = 0, length = 0;
};
std::size_t segment_length(std::size_t samples);
Segment early_segment(std::size_t samples);
/// The end of the row. It begins an eighth of the row after the beginning of the early segment.
Segment late_segment(std::size_t samples);

/// Spectral lines on either side of the peak of the window's main lobe.
inline constexpr std::size_t kMainLobe = 4;

/// Blackman–Harris window, 92 dB, scaled to the amplitude of a sinusoid: modes that still ring beside a tone do not
/// leak into it.
std::vector<double> window_of(std::size_t length);

/// Amplitude of a sinusoid in a segment, its phase at sample 0 of the row. The window has the segment's length.
Complex amplitude_in(std::span<const double> x, const Segment& segment, const std::vector<double>& window,
                     double turns_per_sample);

/// The amplitude in the late segment of each signal.
std::vector<Complex> amplitudes_of(std::span<const ToneSignal> signals, const std::vector<double>& window,
                                   double turns_per_sample);

/// Frequency, in turns per sample, from the phase advance between the segments, over all signals; 0 if the power
/// changes. theory (1.10)
double refined_turns_per_sample(std::span<const ToneSignal> signals, const std::vector<double>& window,
                                double turns_per_sample);

}  // namespace percuss::pipeline
