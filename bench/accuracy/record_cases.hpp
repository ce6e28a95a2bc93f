#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::accuracy {

/// How much is tried: everything, or as little as shows that everything runs.
enum class Extent { full, quick };

/// A test whose records an analysis is tried on, and what it stands for in its sweep.
struct RecordCase {
  std::string value;
  synth::SynthSpec spec;  // spec.runs: how many noisy runs
};

struct RecordSweep {
  std::string over;
  std::vector<RecordCase> cases;
};

/// The main case is the bundled composite bat (six modes, two of them 12 Hz apart; five hits, two accelerometers, one
/// second) with 1 % of noise on the accelerations and an exact force, over 64 runs. One thing is changed at a time;
/// numbers of modes and channels are those of a plainer structure (see spread_structure).
std::vector<RecordSweep> record_sweeps(Extent extent);

/// Modes spread evenly over 150 to 3000 Hz, 0.2 to 0.5 % of damping, residues of 0.3 to 1.5 /kg of either sign, for so
/// many accelerometers; one second at 8192 Hz, three hits, 1 % of noise on the accelerations.
synth::SynthSpec spread_structure(std::size_t modes, std::size_t channels);

}  // namespace percuss::accuracy
