#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace percuss::acquire {

/// How the points of a structure lie.
enum class PointLayout { scattered, line, grid, plane, surface };

/// Lines and faces that connect the points of a structure in drawings, as indices into its points.
struct StructureMesh {
  PointLayout layout = PointLayout::scattered;
  std::vector<std::array<std::size_t, 2>> lines;
  std::vector<std::vector<std::size_t>> faces;  // three corners or more, in order around the face
  std::vector<std::array<double, 3>> normals;   // [points] unit vectors
};

/// A mesh for points without lines of their own:
///   line     neighbours along a beam
///   grid     rows and columns of a plane grid
///   plane    Delaunay triangles in the plane, without long ones along the outline
///   surface  triangles around the middle of the points
/// Normals point outwards. The normal of a plane points to the positive side of its largest component; normals of a
/// line are as close to z as possible, or to x for a line along z. Nothing is connected if there are more than 2000
/// points, since the time grows with their square.
StructureMesh structure_mesh(std::span<const std::array<double, 3>> points_m);

/// The edges of faces, each once, ascending.
std::vector<std::array<std::size_t, 2>> edges_of(const std::vector<std::vector<std::size_t>>& faces);

/// A normal per point: the mean of its faces' normals. The normals of a closed structure point outwards. The normals of
/// an open structure point to the side of `towards`. All faces must have the same sense of rotation. Points without a
/// face have `towards`.
std::vector<std::array<double, 3>> normals_of(std::span<const std::array<double, 3>> points_m,
                                              const std::vector<std::vector<std::size_t>>& faces,
                                              const std::array<double, 3>& towards);

}  // namespace percuss::acquire
