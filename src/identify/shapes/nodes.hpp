#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "identify/shapes/scan_shape.hpp"

namespace percuss::identify {

struct Node {
  double position_m = 0;
  double std_m = 0;
  int degree = 0;          // of the polynomial whose root it is
  std::size_t points = 0;  // that it was fitted to
};

struct NodeOptions {
  std::size_t points = 17;  // nearest to a crossing that are fitted
  int highest_degree = 5;   // of a polynomial: fourth powers follow a beam over half a wavelength to 1e-3 of its height
};

/// Where the shape passes through zero: between neighbouring points of opposite sign, both three deviations from zero,
/// the root of a polynomial in the position fitted to the points around by weighted least squares. Its degree is the
/// one with the least χ² + k ln n. The deviation is that of the next higher degree's root, scaled by its χ² where that
/// is larger than it should be, and, squares added, the distance to that root, which stands for the model's error.
/// theory (5.8)
std::vector<Node> find_nodes(const ScanShape& shape, const NodeOptions& options = {});

/// The rule of thumb [8], section 3.6: where the mode's peak passes through its minimum, to the nearest multiple of
/// `resolution_m`. The bottom of the V that |shape| forms between the lowest point and its lower neighbour. Nothing for
/// fewer than three points, or when the lowest one is at an end and the peak still falls towards it.
std::optional<double> minimum_of_peak(std::span<const double> position_m, std::span<const double> peak,
                                      double resolution_m);

}  // namespace percuss::identify
