#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// A place on a tube, by its axial position and its angle.
struct TubePlace {
  double position_m = 0;
  double angle_rad = 0;
};

/// The places of the survey points on the tube, by point number.
using TubeGeometry = std::map<std::size_t, TubePlace>;

/// The shape's amplitude on a ring of points, in the plane of the pattern.
struct AxialValue {
  double position_m = 0;
  double value = 0;
  double std = 0;
};

/// A mode's shape on a tube as axial functions times cos nθ and sin nθ.
struct TubeShape {
  std::vector<double> energy;  // [n] fraction of the shape's energy over the points, without the noise
  int order = 0;               // n with the largest energy: 0 breathing, 1 bending, 2 and above hoop (ovalling, …)
  double confidence = 0;       // probability of this order, with noise, 10 % mixing of orders and its alias
  int alias = 0;               // lowest higher order with the same pattern at these angles
  std::optional<double> plane_rad;  // an antinode, 0 … π/n; nothing for n = 0 or where not observable
  double plane_std_rad = 0;
  std::vector<AxialValue> axial;    // [rings] along the axis, for `order`
  std::optional<int> sign_changes;  // of `axial` where significant; nothing for a single ring
};

/// Decomposes a shape into circumferential orders. Rings (points of one axial position) with four angles or more are
/// fitted by least squares, for n = 0 … (angles − 1)/2 and the observable part of n = angles/2:
///   φ(x, θ) = Σ_n g_n(x) cos n(θ − θ_n) + …                                                               (1)
/// Where the rings leave a gap of more than 149°, each order is fitted alone: the orders are not orthogonal there.
/// Six angles 60° apart show n = 0, 1, 2 and only the cosine of n = 3; n = 4 has the pattern of n = 2 (`alias`). The
/// first of several channels at a place is used. Nothing where no ring has four angles with known values.
/// theory (5.7)
std::optional<TubeShape> tube_shape(const ModeShape& shape, const TubeGeometry& geometry);

/// Bending for n = 1, hoop for n = 2; unknown for other orders or low confidence.
ModeType mode_type_of(const TubeShape& shape);

}  // namespace percuss::identify
