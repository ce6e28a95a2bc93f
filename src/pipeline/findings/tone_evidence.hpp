#pragma once
#include <span>
#include <vector>

#include "core/math/fft.hpp"
#include "pipeline/findings/tones.hpp"

// Evidence that distinguishes tones from modes. `turns` is a frequency in turns per sample, `amplitude` the sinusoid's
// amplitude in each signal.
namespace percuss::pipeline {

/// Whether the phase relative to the force differs from hit to hit. The phase of a mode is fixed, up to its sign.
bool has_free_phase(std::span<const ToneSignal> signals, const std::vector<Complex>& amplitude, double turns);

/// Whether the sinusoid, extended to the time before the hits, describes the signal there.
bool is_there_before(std::span<const ToneSignal> signals, const std::vector<Complex>& amplitude, double turns);

/// Whether the amplitude, as a complex number, differs between the halves of the late segment.
bool wanders_along(std::span<const ToneSignal> signals, double turns);

/// Whether the amplitude, as a complex number, differs between the early and the late segment. These are twice as long
/// as the halves of wanders_along(), so that a mode near the tone that still rings matters less. The frequency must not
/// be estimated from this tone: refined_turns_per_sample() would fit the difference.
bool wanders_between_segments(std::span<const ToneSignal> signals, double turns);

}  // namespace percuss::pipeline
