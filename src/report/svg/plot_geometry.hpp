#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// A point of the survey's geometry; nullptr when it is not in it.
const acquire::GeometryPoint* geometry_point_of(const pipeline::Survey& survey, std::size_t point);

/// A point's coordinates for drawing: its own, or from its place on the tube (axis along x); nothing when not known.
std::optional<std::array<double, 3>> plot_position(const pipeline::Survey& survey, std::size_t point);

/// Which way a point moves when it moves outwards: along the normal of a tube whose axis is x, where a sensor's angle
/// is known along that (`sensors`), else along z. `survey` may be nullptr.
std::array<double, 3> outward_normal(const pipeline::Survey* survey, const pipeline::Analysis& analysis,
                                     std::size_t point, std::size_t channel, bool sensors);

/// The lines between these points: the record's own; else rings around a tube and lines along it.
std::vector<acquire::TraceLine> plot_lines(const pipeline::Survey& survey, const std::set<int>& points);

}  // namespace percuss::report
