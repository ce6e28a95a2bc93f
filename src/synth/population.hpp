#pragma once
#include <cstdint>
#include <vector>

#include "metrics/study/study_table.hpp"

namespace percuss::synth {

/// The number of bats of each material and the relations among their properties. The materials follow [8]: wood with a
/// BBCOR near 0.480; aluminium with hoop frequencies of 1800 to 2400 Hz; composite with 1300 to 2800 Hz, lower when
/// broken in.
struct PopulationSpec {
  std::uint64_t seed = 1;
  std::size_t wood = 60, aluminum = 60, composite = 60;
  bool related = true;      // false: among bats of one length, performance depends on no property
  double hoop_gain = 4e-5;  // increase of BBCOR per Hz below 2800 Hz
  double noise = 0.004;     // standard deviation of BBCOR
  bool break_in = true;     // add one composite bat during its break-in: 1970 → 1354 Hz, then failure
};

/// Draws a population with known relations: BBCOR = 0.480 (+ gain (2800 Hz − hoop) for hollow bats) + noise, without
/// any other dependence. BESR and batted-ball speed at 6 in follow by (P9) and (P8), so BESR rises with MOI. The
/// numbers are the same with every compiler.
std::vector<metrics::StudyBat> synthetic_population(const PopulationSpec& spec = {});

}  // namespace percuss::synth
