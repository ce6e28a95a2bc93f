#pragma once
#include <string>
#include <vector>

#include "figures.hpp"
#include "scaling.hpp"

namespace percuss::accuracy {

/// Charts of error against time, one per sweep, as an SVG document. A colour marks a case, a symbol a method, and a
/// line joins the Pareto-optimal figures of a case. A sweep with nearly equal figures has no chart.
std::string task_svg(const TaskFigures& task);

/// Charts of time and of memory against size.
std::string scaling_svg(const std::vector<Scaling>& scalings);

}  // namespace percuss::accuracy
