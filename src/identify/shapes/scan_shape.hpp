#pragma once
#include <span>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mode's shape along a line of impact points: one signed number each, positive at the first.
struct ScanShape {
  std::vector<double> position_m;  // ascending
  std::vector<double> amplitude;   // 1/kg, the residue as the channel that sees the mode best has it
  std::vector<double> std;
};

/// The residues of a mode at the points of a scan, all channels joined: the first singular vector of [points ×
/// channels] with every channel in units of its own deviation, turned to be as real as it gets. point[i] lies at
/// position_m[i]; points without residues are left out, residues of other points too.
ScanShape shape_along(const Mode& mode, std::span<const int> point, std::span<const double> position_m);

}  // namespace percuss::identify
