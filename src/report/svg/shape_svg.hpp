#pragma once
#include <array>
#include <string>
#include <vector>

#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

using Polyline = std::vector<std::array<double, 2>>;  // right and up, in any unit

/// A shape at rest and at its largest deflection. `values` are the signed deflections of the moved lines, −1 … 1, from
/// vermilion over grey to blue; without them, all are blue. `signs` mark their extremes.
struct DeformedShape {
  struct Sign {
    std::array<double, 2> at{};
    bool positive = true;
  };
  std::string name;
  std::vector<Polyline> rest, moved;
  std::vector<double> values{};  // [moved], or empty
  std::vector<Sign> signs{};
};

/// Drawings at one scale in rows, with their names.
SvgFragment shape_svg(const std::string& title, const std::vector<DeformedShape>& drawings);

}  // namespace percuss::report
