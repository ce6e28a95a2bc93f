#pragma once
#include <span>
#include <vector>

#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mode's shape along a line of impact points: one real value per point, positive at the first point.
struct ScanShape {
  std::vector<double> position_m;  // ascending
  std::vector<double> amplitude;   // 1/kg, on the scale of the channel with the largest residues
  std::vector<double> std;
};

/// The shape from the residues of all channels at the points of a scan: the first singular vector of [points ×
/// channels], rotated to be as real as possible. Each channel is divided by its standard deviation. point[i] lies at
/// position_m[i]. Points without a residue for every channel are omitted, and so are residues of other points.
ScanShape shape_along(const Mode& mode, std::span<const int> point, std::span<const double> position_m);

/// [channels] the factors by which shape_along() multiplies the residues of a point; the real part of the sum is the
/// amplitude. Empty without a point that has a residue for every channel.
std::vector<Complex> channel_factors(const Mode& mode, std::span<const int> point, std::span<const double> position_m);

}  // namespace percuss::identify
