#include "report/svg/tube_mesh.hpp"

#include <gtest/gtest.h>

#include "core/units.hpp"

namespace percuss::report::tube_mesh_test {

// Two rings with points at these angles; the points count from 0, ring by ring.
acquire::StructureMesh mesh_of(const std::vector<double>& angles_deg) {
  acquire::Geometry geometry{.points = {}, .tube = true};
  std::map<int, std::size_t> index;
  for (const double position_m : {0.1, 0.2}) {
    for (const double angle_deg : angles_deg) {
      const auto point = static_cast<int>(index.size());
      geometry.points.push_back(
          {.point = point, .xyz_m = {}, .position_m = position_m, .angle_rad = angle_deg * kDegree_rad});
      index.emplace(point, index.size());
    }
  }
  return tube_mesh(geometry, index);
}

TEST(TubeMesh, ClosesAWholeRing) {
  const auto mesh = mesh_of({0, 60, 120, 180, 240, 300});
  EXPECT_EQ(mesh.lines.size(), 12U + 6U);
  EXPECT_EQ(mesh.faces.size(), 6U);
}

TEST(TubeMesh, LeavesAHalfTubeOpenWhereverItLies) {
  for (const double turn_deg : {0.0, -90.0, 100.0, -180.0}) {
    std::vector<double> angles_deg;
    for (int i = 0; i <= 6; ++i) angles_deg.push_back(30 * i + turn_deg);
    const auto mesh = mesh_of(angles_deg);
    EXPECT_EQ(mesh.lines.size(), 12U + 7U) << turn_deg;
    EXPECT_EQ(mesh.faces.size(), 6U) << turn_deg;
  }
}

TEST(TubeMesh, JoinsTwoPointsOfARing) {
  EXPECT_EQ(mesh_of({0, 180}).lines.size(), 2U + 2U);
  EXPECT_EQ(mesh_of({0, 180}).faces.size(), 1U);
}

}  // namespace percuss::report::tube_mesh_test
