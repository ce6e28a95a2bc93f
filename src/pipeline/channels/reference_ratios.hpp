#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// A point of a roving-hammer survey at which two fixed sensors contradict the other points.
struct ReferenceContradiction {
  std::size_t point = 0;   // its number
  std::size_t first = 0;   // channel
  std::size_t second = 0;  // channel
  double factor = 1;       // (second over first) here over the same ratio at the other points: -1, 9.81, 0
  std::size_t modes = 0;   // that show the factor
};

/// The points at which one real factor, far from 1, relates the ratio of two channels' residues to this ratio at the
/// other points, in all clear modes. At each point A_pc = φ_p φ_c, so that the ratio of two sensors depends on the mode
/// alone. A reversed, disconnected or wrongly scaled channel in the data of some points has such a factor. Of two
/// groups of points that contradict each other, the smaller one is returned. Empty for fewer than three modes or six
/// points. theory (5.1)
std::vector<ReferenceContradiction> reference_contradictions(const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
