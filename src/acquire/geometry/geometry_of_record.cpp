#include <algorithm>
#include <cmath>

#include "acquire/geometry/geometry.hpp"
#include "core/units.hpp"

namespace percuss::acquire {

std::optional<Geometry> geometry_of_record(const std::vector<std::vector<double>>& rows) {
  if (rows.empty()) return std::nullopt;
  Geometry geometry;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    GeometryPoint point{.point = static_cast<int>(i)};
    // NaN marks a number without a point, in formats whose point numbers have gaps.
    if (std::any_of(rows[i].begin(), rows[i].end(), [](double x) { return std::isnan(x); })) continue;
    if (rows[i].size() == 3) {
      point.xyz_m = {rows[i][0], rows[i][1], rows[i][2]};
    } else if (rows[i].size() == 2) {
      point.position_m = rows[i][0];
      point.angle_rad = rows[i][1] * kDegree_rad;
    } else {
      return std::nullopt;
    }
    geometry.points.push_back(point);
  }
  if (geometry.points.empty()) return std::nullopt;
  geometry.tube = rows.front().size() == 2;
  if (!geometry.tube) tube_from_coordinates(geometry);
  return geometry;
}

}  // namespace percuss::acquire
