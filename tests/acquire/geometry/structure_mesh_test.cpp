#include "acquire/geometry/structure_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace percuss::acquire::structure_mesh_test {

using Points = std::vector<std::array<double, 3>>;
using testing::ElementsAre;

constexpr double kRounding = 1e-12;

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::set<std::size_t> connected_points(const StructureMesh& mesh) {
  std::set<std::size_t> out;
  for (const auto& line : mesh.lines) out.insert(line.begin(), line.end());
  return out;
}

double plane_area(const Points& points, const StructureMesh& mesh) {
  double sum = 0;
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto &a = points[face[i]], &b = points[face[(i + 1) % face.size()]];
      sum += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
  }
  return sum;
}

TEST(StructureMesh, ConnectsTheNeighboursOfABeam) {
  const StructureMesh mesh = structure_mesh(Points{{0, 0, 0.5}, {0, 0, 0.1}, {0, 0, 1.2}, {0, 0, 0.3}});
  EXPECT_EQ(mesh.layout, PointLayout::line);
  using Line = std::array<std::size_t, 2>;
  EXPECT_THAT(mesh.lines, ElementsAre(Line{1, 3}, Line{3, 0}, Line{0, 2}));
  EXPECT_TRUE(mesh.faces.empty());
  for (const auto& normal : mesh.normals) EXPECT_EQ(normal, (std::array<double, 3>{1, 0, 0})) << "across the beam";
  const StructureMesh level = structure_mesh(Points{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}});
  EXPECT_EQ(level.layout, PointLayout::line);
  EXPECT_EQ(level.normals[0], (std::array<double, 3>{0, 0, 1}));
}

TEST(StructureMesh, KeepsTwoRowsOfABeamApart) {
  Points points;
  for (int i = 0; i < 10; ++i) {
    points.push_back({0.1 * i, 0, 0});
    points.push_back({0.1 * i, 0.015, 0});
  }
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::grid);
  EXPECT_EQ(mesh.lines.size(), 10U + 2 * 9);
  EXPECT_EQ(mesh.faces.size(), 9U);
}

TEST(StructureMesh, ConnectsRowsAndColumnsOfAGrid) {
  Points points;
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 5; ++k) {
      if (i != 4 || k != 2) points.push_back({0.1 * i, 0.05 * k, 0});  // a hole in the middle
    }
  }
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::grid);
  EXPECT_EQ(mesh.faces.size(), 8U * 4 - 4);
  EXPECT_EQ(mesh.lines.size(), 8U * 5 + 9U * 4 - 4);
  EXPECT_NEAR(plane_area(points, mesh), 0.8 * 0.2 - 4 * 0.1 * 0.05, kRounding);
  for (const auto& normal : mesh.normals) EXPECT_NEAR(normal[2], 1, kRounding);
}

// The largest component of the normal of an upright plate is positive, whichever way the corners run.
TEST(StructureMesh, FindsTheNormalOfAnUprightPlate) {
  Points points;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) points.push_back({0.1 * i, 0.7, 0.1 * k});
  }
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::grid);
  for (const auto& normal : mesh.normals) EXPECT_NEAR(normal[1], 1, kRounding);
}

TEST(StructureMesh, CoversAnIrregularPlateOnce) {
  Points points;
  for (const double along : {0.0, 0.2, 0.45, 0.7}) {
    points.push_back({along, 0, 0});
    points.push_back({1, along, 0});
    points.push_back({1 - along, 1, 0});
    points.push_back({0, 1 - along, 0});
  }
  for (int i = 0; i < 30; ++i) points.push_back({0.1 + 0.8 * std::fmod(0.618 * i, 1), 0.1 + 0.8 * (i / 30.0), 0});
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::plane);
  EXPECT_EQ(connected_points(mesh).size(), points.size());
  EXPECT_NEAR(plane_area(points, mesh), 1, kRounding);
}

// An L-shaped plate. Triangles across its notch would have long edges.
TEST(StructureMesh, LeavesANotchOpen) {
  Points points;
  for (int i = 0; i < 12; ++i) {
    for (int k = 0; k < 12; ++k) {
      if (i < 4 || k < 4) points.push_back({0.1 * i + 0.01 * std::sin(7 * k), 0.1 * k + 0.01 * std::sin(5 * i), 0});
    }
  }
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::plane);
  EXPECT_EQ(connected_points(mesh).size(), points.size());
  // The tolerance is a fifth of the triangle that the hull adds across the notch: the points lie up to 0.01 beside the
  // outline.
  const double l_shape = 1.1 * 1.1 - 0.8 * 0.8, hull = 1.1 * 1.1 - 0.8 * 0.8 / 2;
  EXPECT_LT(std::abs(plane_area(points, mesh) - l_shape), 0.2 * (hull - l_shape)) << "hull " << hull;
}

TEST(StructureMesh, ClosesASurfaceAroundABox) {
  Points points;
  for (int i = 0; i < 6; ++i) {  // a box beam of 2 m
    for (const double y : {-0.05, 0.0, 0.05}) {
      for (const double z : {-0.05, 0.0, 0.05}) {
        if (y != 0 || z != 0 || i == 0 || i == 5) points.push_back({0.4 * i, y, z});
      }
    }
  }
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::surface);
  EXPECT_EQ(mesh.faces.size(), 2 * points.size() - 4) << "Euler: a closed surface through all points";
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[p][0] == 0 || points[p][0] == 2) continue;
    EXPECT_GT(dot(mesh.normals[p], {0, points[p][1], points[p][2]}), 0) << "outwards at point " << p;
  }
}

TEST(StructureMesh, DoesNotFoldTheSidesOfAFlatBoxOntoEachOther) {
  Points points;
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 5; ++k) {
      for (const double z : {0.0, 0.005}) points.push_back({0.1 * i, 0.1 * k, z});
    }
  }
  EXPECT_EQ(structure_mesh(points).layout, PointLayout::surface);
}

TEST(StructureMesh, IsEmptyForPointsThatHaveNoSize) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const Points& points : {Points{}, Points{{1, 2, 3}}, Points{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
                               Points{{0, 0, 0}, {1, 0, kNan}, {0, 1, 0}}}) {
    const StructureMesh mesh = structure_mesh(points);
    EXPECT_TRUE(mesh.lines.empty());
    EXPECT_TRUE(mesh.faces.empty());
    EXPECT_EQ(mesh.normals.size(), points.size());
  }
}

TEST(StructureMesh, LeavesManyPointsUnconnected) {
  Points points;
  for (int i = 0; i < 3000; ++i) points.push_back({0.1 * i, 0, 0});  // the limit is 2000
  EXPECT_TRUE(structure_mesh(points).lines.empty());
}

TEST(StructureMesh, KeepsCoincidingPointsFromBreakingAPlane) {
  Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.5, 0}, {0.4, 0.5, 0}};
  const StructureMesh mesh = structure_mesh(points);
  EXPECT_EQ(mesh.layout, PointLayout::plane);
  EXPECT_NEAR(plane_area(points, mesh), 1, kRounding);
}

}  // namespace percuss::acquire::structure_mesh_test
