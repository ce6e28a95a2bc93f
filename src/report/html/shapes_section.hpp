#pragma once
#include <string>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// The section of the mode shapes: a figure for page/shapes.js, the MAC matrix, and the `warnings` beside them, as
/// HTML. The survey must have modes.
std::string shapes_section(const pipeline::Survey& survey, const std::string& warnings);

/// The data of the figure, as JSON in ASCII:
///   shapes.points, lines, faces, normals, layout, sensors {at, direction}
///   shapes.modes   {name, hz, mpc, moves}: real and imaginary parts along x, y, z per point, in 1/10000 of the largest
std::string shapes_plot_data(const pipeline::Survey& survey);

}  // namespace percuss::report
