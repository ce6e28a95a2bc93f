#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace percuss {
inline namespace core {

/// Corners of a triangle, as indices into points.
using Triangle = std::array<std::size_t, 3>;

/// Delaunay triangulation: counter-clockwise triangles that cover the convex hull of points in the plane and whose
/// circumcircles hold no other point. The triangles are the lower hull of the points lifted to z = x² + y². Signs are
/// exact: coordinates are rounded to 2⁻²⁰ of the larger extent first. A point that coincides with an earlier one is in
/// no triangle. Empty if all points lie on a line. Time O(n²).
/// errors  coordinates that are not finite give an empty result.
std::vector<Triangle> delaunay_triangles(std::span<const std::array<double, 2>> points);

/// Triangulation of the directions (unit vectors) from the origin: the convex hull of their points on the sphere, with
/// triangles counter-clockwise as seen from outside. Directions closer than about 10⁻⁴ may be in no triangle. Empty if
/// a direction is zero or not finite, or if the directions lie in a plane. Time O(n²).
std::vector<Triangle> sphere_triangles(std::span<const std::array<double, 3>> directions);

}  // namespace core
}  // namespace percuss
