#pragma once
#include <cstddef>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::pipeline {

/// A mode whose frequency falls, from point to point, with the square of its residue there: what the mass of a roving
/// sensor does, Δf/f = −m φ²/2.
struct MassLoading {
  std::size_t mode = 0;
  double largest_fall = 0, std = 0;  // of the frequency, relative: where the mode moves most against where it is still
  std::size_t points = 0;
};

/// The modes whose frequencies differ between the points and fall so beyond doubt. Empty where another mode rises: then
/// something else moves the frequencies.
std::vector<MassLoading> mass_loading(const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
