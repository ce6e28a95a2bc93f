#pragma once
#include <vector>

#include "synth/pulse.hpp"
#include "synth/synthesise.hpp"

namespace percuss::synth {

/// The hits of one run: onset, width and peak of each drawn from its own random stream, faults worked in. A fault
/// changes its own hit only.
std::vector<TrueHit> schedule_hits(const SynthSpec& spec);

/// The pulses of a hit: none (missing), one, or two (double hit).
std::vector<Pulse> pulses_of(const SynthSpec& spec, const TrueHit& hit);

/// Rows of one run: as many as hits, or one.
std::size_t rows_per_run(const SynthSpec& spec);

}  // namespace percuss::synth
