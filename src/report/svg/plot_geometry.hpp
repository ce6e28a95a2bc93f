#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "acquire/geometry/structure_mesh.hpp"
#include "pipeline/survey.hpp"

namespace percuss::report {

/// A point's coordinates for drawing: its own, or from its position on the tube (axis along x); nothing if not known. A
/// tube whose radius is not stated is drawn with the radius of a bat's barrel, limited to 5 to 50 % of its length.
std::optional<std::array<double, 3>> plot_position(const pipeline::Survey& survey, std::size_t point);

/// The measured places of a survey, how drawings connect them, and the direction of a positive response at each.
struct PlotMesh {
  std::map<int, std::size_t> index;           // of each point number; several points can be at one place
  std::vector<int> number;                    // [points], ascending
  std::vector<std::array<double, 3>> points;  // m
  std::vector<std::array<std::size_t, 2>> lines;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::array<double, 3>> normals;  // unit vectors; the stated direction of a place that has one
  acquire::PointLayout layout = acquire::PointLayout::scattered;
};

/// Contains the points whose coordinates are known. Lines and faces come from the geometry, or from the record if the
/// geometry has none. If neither has any, they are rings around a tube and lines along it, or those of
/// structure_mesh(). The survey must have modes.
PlotMesh plot_mesh(const pipeline::Survey& survey);

/// Direction of a positive response: the first of these that is known.
///   the direction that the geometry or the record states for the point
///   on a structure that is no tube: with `sensors`, the stated angle of the sensor; the axis of the sensor or hammer;
///   with `sensors`, an assumed angle
///   the point's normal
/// Along z if none is known.
std::array<double, 3> response_direction(const PlotMesh* mesh, const pipeline::Survey* survey,
                                         const pipeline::Analysis& analysis, std::size_t point, std::size_t channel,
                                         bool sensors);

}  // namespace percuss::report
