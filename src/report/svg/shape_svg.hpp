#pragma once
#include <array>
#include <string>
#include <vector>

#include "report/svg/svg_fragment.hpp"

namespace percuss {

using DrawnLine = std::vector<std::array<double, 2>>;  // right and up, in any unit

/// Something that moves, at rest and where it has moved farthest.
struct StillDrawing {
  std::string name;
  std::vector<DrawnLine> rest, moved;
};

/// Drawings of one scale beside and under one another, with their names.
SvgPiece still_drawings(const std::string& title, const std::vector<StillDrawing>& drawings);

}  // namespace percuss
