#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
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
  std::size_t points = 17;  // at most in a fit, the nearest to the crossing
  /// Of a node's polynomial. Degree 4 follows a sine over half a wavelength to 5e-3 of its height.
  int highest_degree = 5;
};

/// The nodes: zero crossings of the shape. A crossing lies between two points of opposite sign, both more than three
/// standard deviations from zero; points between them are closer to zero than that. The node is the root of a
/// polynomial in the position, fitted by weighted least squares to the n points nearest to the crossing, four or more.
/// The degree k and the number n minimise χ²/s² + (k + N − n) ln N, where N is the number of points at most. A point
/// that is left out counts as a coefficient.
/// s² is χ² per degree of freedom of the fit of the highest degree, at least 1. n grows from three degrees of freedom
/// until a point contradicts the polynomial (once in 100 cases); s² is the largest value on the way. A scan may have
/// more nodes than one polynomial can follow, so each node is fitted on its own.
/// The variance of the position is a sum of two terms:
///   root         the variance of the root of the next higher degree, times the larger of s² and the χ² per degree of
///                freedom of its fit. If the points scatter beyond their standard deviations, the standard deviation is
///                also multiplied by Student's factor.
///   model error  the larger squared distance to the root of the next higher degree and to the root with two points
///                less
/// Where the next higher degree has no root, the first term is the variance of the fit itself, and the next lower
/// degree gives the distance.
/// theory (5.8)
std::vector<Node> find_nodes(const ScanShape& shape, const NodeOptions& options = {});

/// Why a mode has no node along a scan.
enum class NoNode {
  few_positions,  // fewer than three
  varies,         // the hits of one position differ by more than half the mode's rms amplitude
  uncertain,      // fewer than two points have a certain sign
  same_sign,      // all points that have a certain sign have the same one
  wide            // each crossing is as uncertain as if it could be anywhere in the scan
};
std::string_view name_of(NoNode reason);

/// Removes nodes whose standard deviation is as large as for a place anywhere in the scan: its length over √12.
void drop_wide_nodes(std::vector<Node>& nodes, const ScanShape& shape);

/// The reason by the shape, if find_nodes() finds no node, or drop_wide_nodes() leaves none.
NoNode reason_without_node(const ScanShape& shape);

/// The node by the rule of thumb of [8], section 3.6: the position of the minimum of the mode's peak, rounded to
/// `resolution_m`. The minimum is the bottom of the V of |shape| between the lowest point and its lower neighbour.
/// Nothing for fewer than three points, where the lowest point has more than half of the largest peak, or where the
/// lowest point is at an end and the peak still falls towards it.
std::optional<double> minimum_of_peak(std::span<const double> position_m, std::span<const double> peak,
                                      double resolution_m);

}  // namespace percuss::identify
