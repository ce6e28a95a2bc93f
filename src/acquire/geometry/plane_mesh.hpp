#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "acquire/geometry/structure_mesh.hpp"

namespace percuss::acquire {

/// Rows and columns through points that lie on a rectangular grid along both coordinates, complete or with holes, and
/// a face per cell. Nothing if they form no grid: fewer than two rows or columns, or less than 60 % of it occupied.
std::optional<StructureMesh> grid_mesh(std::span<const std::array<double, 2>> points);

/// Delaunay triangles. Along the outline, triangles with an edge longer than three times the median edge are removed,
/// so that a waist or a notch shows (Duckham et al., Pattern Recognition 41, 2008).
StructureMesh triangle_mesh(std::span<const std::array<double, 2>> points);

}  // namespace percuss::acquire
