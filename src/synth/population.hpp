#pragma once
#include <cstdint>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::synth {

/// How many bats of each family, and what goes with what. Families as [8] describes them: wood with a BBCOR near 0.480;
/// aluminium with hoop frequencies of 1800 to 2400 Hz; composite with 1300 to 2800 Hz, the lower ones broken in.
struct PopulationSpec {
  std::uint64_t seed = 1;
  std::size_t wood = 60, aluminum = 60, composite = 60;
  bool related = true;      // false: performance of each length is drawn without regard to anything else
  double hoop_gain = 4e-5;  // of BBCOR per Hz below 2800 Hz
  double noise = 0.004;     // of BBCOR
  bool trail = true;        // also one composite bat over its break-in: 1970 → 1354 Hz, then failing
};

/// A population whose relations are known: BBCOR = 0.480 (+ gain (2800 Hz − hoop) for hollow bats) + noise, with regard
/// to nothing else; BESR and batted-ball speed at 6 in follow from it by (P9) and (P8), so that BESR rises with MOI.
/// The same numbers with every compiler.
std::vector<metrics::StudyBat> synthetic_population(const PopulationSpec& spec = {});

}  // namespace percuss::synth
