#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/shapes/circumferential_orders.hpp"

namespace percuss::identify {

/// The least-squares fit of a ring of points by 1, cos θ, sin θ, cos 2θ, …: coefficients = inverse · value.
struct CircumferentialFit {
  Eigen::MatrixXd pattern;          // [points, 1 + 2 highest], 1, cos θ, sin θ, …
  Eigen::MatrixXd inverse;          // its pseudo-inverse
  Eigen::VectorXd value, variance;  // [points] of the real shape
  double position_m = 0;
  bool half = false;  // only one combination of the highest order's cosine and sine is observable
};

struct CircumferentialFits {
  std::vector<CircumferentialFit> rings;  // along the axis; empty where the points resolve no order
  int highest = 0;                        // highest circumferential order
  // Number of angles of the ring that has the fewest. On an arc: the number on a full circle with the arc's spacing.
  std::size_t angles = 0;
  // The points cover a part of the circle, where the orders are not orthogonal: each order is fitted alone, and its
  // energy is what it explains alone.
  bool arc = false;
};

/// Fits the rings of four angles or more, up to the highest order that every ring resolves. See tube_shape.
CircumferentialFits fit_circumferential(const ModeShape& shape, const TubeGeometry& geometry);

}  // namespace percuss::identify
