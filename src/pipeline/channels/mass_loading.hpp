#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// A mode whose frequency differs between the points: the larger the square of its residue at a point, the lower its
/// frequency in the FRFs of this point. The mass of a roving sensor has this effect: Δf/f = −m φ²/2.
struct MassLoading {
  std::size_t mode = 0;
  double largest_fall = 0, std = 0;  // of the frequency, relative: from a node to the point that moves most
  std::size_t points = 0;            // where the frequency was estimated separately
};

/// The modes whose frequencies differ between the points and fall in this way beyond doubt. Empty if more than one in
/// six frequencies rises in this way: another cause then changes the frequencies.
std::vector<MassLoading> mass_loading(const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
