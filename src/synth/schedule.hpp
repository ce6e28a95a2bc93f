#pragma once
#include <vector>

#include "synth/pulse.hpp"
#include "synth/synthesise.hpp"

namespace percuss::synth {

/// Draws the hits of one run, each with its own random stream for onset, width and peak, and applies the faults. A
/// fault changes only its own hit.
std::vector<TrueHit> schedule_hits(const SynthSpec& spec);

/// The pulses of a hit: none (missing), one, or two (double hit).
std::vector<Pulse> pulses_of(const SynthSpec& spec, const TrueHit& hit);

/// The rows of one run: one per hit, or a single one.
std::size_t rows_per_run(const SynthSpec& spec);

}  // namespace percuss::synth
