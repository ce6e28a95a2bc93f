#pragma once
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "acquire/record/point_motion.hpp"
#include "identify/shapes/mode_shapes.hpp"

namespace percuss::pipeline {

/// A shape's components along the outward normals n of a tube, one per place, from components along stated directions
/// d_i (unit vectors):
///   Σ c_i φ_i, where Σ c_i d_i = n and c_i = d_i·n                                                        (1)
/// Where Σ c_i d_i is not n, the component whose direction lies nearest to the line of n, and within 45° of it, counts
/// as radial, with the sign of c_i. Other places are left out. A component without a stated direction is radial.
/// Where all points move along one line that is not radial everywhere, such as the tube's axis, the components are
/// returned as they are: they have the same circumferential orders.
/// motions  sorted; geometry  a tube
identify::ModeShape radial_shape(const identify::ModeShape& shape, const std::vector<acquire::PointMotion>& motions,
                                 const acquire::Geometry& geometry);

}  // namespace percuss::pipeline
