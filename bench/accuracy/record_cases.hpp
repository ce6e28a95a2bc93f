#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "synth/spec.hpp"

namespace percuss::accuracy {

/// The extent of a measurement: everything, or a minimum that runs all code.
enum class Extent { full, quick };

/// A test with records for the analysis, and its value in the sweep.
struct RecordCase {
  std::string value;
  synth::SynthSpec spec;  // spec.runs: number of noisy runs
};

struct RecordSweep {
  std::string over;
  std::vector<RecordCase> cases;
};

/// The main case is the bundled composite bat (six modes, two of them 12 Hz apart; five hits, two accelerometers, one
/// second) with 1 % of noise on the accelerations and an exact force, over 64 runs. Each sweep changes one property.
/// The numbers of modes and of channels use a simpler structure (see spread_structure).
std::vector<RecordSweep> record_sweeps(Extent extent);

/// A structure with one mode at a random place of each of `modes` equal parts of 150 to 3000 Hz. Damping ratios are 0.2
/// to 0.5 %, and residues are 0.3 to 1.5 /kg of either sign. The test has three hits of one second at 8192 Hz and 1 %
/// of noise on the accelerations.
synth::SynthSpec spread_structure(std::size_t modes, std::size_t channels);

}  // namespace percuss::accuracy
