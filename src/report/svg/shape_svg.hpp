#pragma once
#include <array>
#include <string>
#include <vector>

#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

using Polyline = std::vector<std::array<double, 2>>;  // right and up, in any unit

/// Something that moves, at rest and where it has moved farthest.
struct DeformedShape {
  std::string name;
  std::vector<Polyline> rest, moved;
};

/// Drawings of one scale beside and under one another, with their names.
SvgFragment shape_svg(const std::string& title, const std::vector<DeformedShape>& drawings);

}  // namespace percuss::report
