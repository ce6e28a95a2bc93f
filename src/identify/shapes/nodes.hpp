#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "identify/shapes/scan_shape.hpp"

namespace percuss::identify {

/// A node of a mode shape along a scan.
struct Node {
  double position_m = 0;
  double std_m = 0;
  int degree = 0;          // of the fitted polynomial
  std::size_t points = 0;  // in the fit
};

struct NodeOptions {
  std::size_t points = 17;  // in a fit, the nearest to the crossing
  /// Degree 4 follows a sine over half a wavelength to 5e-3 of its height; degree 5 gives its model error.
  int highest_degree = 5;
};

/// The nodes: zero crossings of the shape. A crossing lies between two points of opposite sign, both more than three
/// standard deviations from zero; points between them are closer to zero than that. The node is the root of a
/// polynomial in the position, fitted to the points around by weighted least squares. Its degree k minimises
/// χ²/s² + k ln n for n points. s² is χ² per degree of freedom of the fit of the highest degree, and at least 1. The
/// variance is a sum of two terms. The first is the variance of the next higher degree's root, times χ² per degree of
/// freedom where this exceeds 1. The second is the model error: the squared distance to that root. Where there is no
/// such root, the first term is the fit's own variance, and the second the squared distance to the root of the next
/// lower degree. theory (5.8)
std::vector<Node> find_nodes(const ScanShape& shape, const NodeOptions& options = {});

/// The node by the rule of thumb of [8], section 3.6: the position of the minimum of the mode's peak, rounded to
/// `resolution_m`. The minimum is the bottom of the V of |shape| between the lowest point and its lower neighbour.
/// Nothing for fewer than three points, where the lowest point has more than half of the largest peak, or where the
/// lowest point is at an end and the peak still falls towards it.
std::optional<double> minimum_of_peak(std::span<const double> position_m, std::span<const double> peak,
                                      double resolution_m);

}  // namespace percuss::identify
