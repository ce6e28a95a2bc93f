#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/shapes/circumferential_orders.hpp"

namespace percuss::identify {

/// A ring's points and their least-squares solution by 1, cos θ, sin θ, cos 2θ, …: coefficients = inverse · value.
struct CircumferentialFit {
  Eigen::MatrixXd pattern;          // [points, 1 + 2 highest]
  Eigen::MatrixXd inverse;          // its pseudo-inverse
  Eigen::VectorXd value, variance;  // [points] of the shape, turned to be real
  double position_m = 0;
  bool half = false;  // of the highest order one combination only is seen
};

struct CircumferentialFits {
  std::vector<CircumferentialFit> rings;  // along the axis; empty: none resolves anything
  int highest = 0;                        // circumferential order
  std::size_t angles = 0;                 // of the ring with the fewest
};

/// Rings of four angles or more, as many orders as each of them resolves. See tube_shape.
CircumferentialFits fit_circumferential(const ModeShape& shape, const TubeGeometry& geometry);

}  // namespace percuss::identify
