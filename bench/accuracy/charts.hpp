#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "scaling.hpp"

namespace percuss::accuracy {

/// Error against time of every sweep, one chart under the other, as an SVG document: a colour for each case, a mark for
/// each method, and a line through the figures of a case that no other beats in both (Pareto's front). A sweep whose
/// figures are all much the same has no chart.
std::string family_svg(const Family& family);

/// Time and memory over size, a chart each.
std::string scaling_svg(const std::vector<Scaling>& scalings);

}  // namespace percuss::accuracy
