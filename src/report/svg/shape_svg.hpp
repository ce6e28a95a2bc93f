#pragma once
#include <array>
#include <string>
#include <vector>

#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

using Polyline = std::vector<std::array<double, 2>>;  // right and up, in any unit

/// A shape at rest and at its largest deflection.
struct DeformedShape {
  std::string name;
  std::vector<Polyline> rest, moved;
};

/// Drawings at one scale in rows, with their names.
SvgFragment shape_svg(const std::string& title, const std::vector<DeformedShape>& drawings);

}  // namespace percuss::report
