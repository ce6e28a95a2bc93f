#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::identify {

/// A place on a tube: along its axis, and around it.
struct TubePlace {
  double position_m = 0;
  double angle_rad = 0;
};

/// Where the points of a survey lie on the tube, by their numbers.
using TubeGeometry = std::map<std::size_t, TubePlace>;

/// What a ring of points says of the shape's amplitude there, in the plane of the pattern.
struct AxialValue {
  double position_m = 0;
  double value = 0;
  double std = 0;
};

/// A mode's shape on a tube as axial functions times cos nθ and sin nθ.
struct TubeShape {
  std::vector<double> energy;  // [n] fraction of the shape's energy over the points, noise taken off
  int order = 0;               // the n that holds the most: 0 breathing, 1 bending, 2 and above hoop (ovalling, …)
  double confidence = 0;       // that it is the largest, allowing for noise and for shapes that mix by a tenth
  int alias = 0;               // the lowest higher order that these angles show alike
  std::optional<double> plane_rad;  // an antinode, 0 … π/n; nothing for n = 0 and where the angles do not tell
  double plane_std_rad = 0;
  std::vector<AxialValue> axial;    // [rings] along the axis, of the order above
  std::optional<int> sign_changes;  // of it along the axis, where it is significant; nothing for a single ring
};

/// Rings (points of one position) with four angles or more are fitted by least squares, n = 0 … (angles − 1)/2 and what
/// an even number of angles shows of n = angles/2:
///   φ(x, θ) = Σ_n g_n(x) cos n(θ − θ_n) + …                                                               (1)
/// Six angles 60° apart show n = 0, 1, 2 and of n = 3 its cosine alone; n = 4 looks like n = 2 there (`alias`). A place
/// of several channels counts by the first. Nothing when no ring has four angles or nothing of the shape is known
/// there.
/// theory (5.7)
std::optional<TubeShape> tube_shape(const ModeShape& shape, const TubeGeometry& geometry);

/// Bending for n = 1, hoop for n = 2; for all others, or when unsure, unknown.
ModeType mode_type_of(const TubeShape& shape);

}  // namespace percuss::identify
