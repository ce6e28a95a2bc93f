#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// A point of the survey's geometry; nullptr if the geometry lacks it.
const acquire::GeometryPoint* geometry_point_of(const pipeline::Survey& survey, std::size_t point);

/// A point's coordinates for drawing: its own, or from its position on the tube (axis along x); nothing if not known.
std::optional<std::array<double, 3>> plot_position(const pipeline::Survey& survey, std::size_t point);

/// Direction of a positive response at a point: along the normal of a tube whose axis is x; with `sensors`, along the
/// sensor's angle where it is known; else along z. `survey` may be nullptr.
std::array<double, 3> outward_normal(const pipeline::Survey* survey, const pipeline::Analysis& analysis,
                                     std::size_t point, std::size_t channel, bool sensors);

/// Lines between these points: the record's own; else rings around a tube and lines along it.
std::vector<acquire::TraceLine> plot_lines(const pipeline::Survey& survey, const std::set<int>& points);

}  // namespace percuss::report
