#pragma once
#include <vector>

#include "model/bat/beam_structure.hpp"

namespace percuss::model {

/// A solid bat of round slices, from the end of the knob (0) on. shapes: both of the same length, at least one.
struct BatProfile {
  std::vector<double> end_m;       // far end of each slice, ascending
  std::vector<double> diameter_m;  // above zero

  double length_m() const { return end_m.back(); }
};

using BatMaterial = Material;

/// The free bat of the profile.
BeamStructure structure_of(const BatProfile& profile, const BatMaterial& material);

}  // namespace percuss::model
