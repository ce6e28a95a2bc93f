#include "core/math/convex_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

namespace percuss::convex_hull_test {

using Point = std::array<double, 2>;
using Direction = std::array<double, 3>;

// Coordinates are rounded to 2⁻²⁰, about 1e-6, of the extent. Areas and distances allow for ten such steps.
constexpr double kRounding = 1e-5;

double area(const Point& a, const Point& b, const Point& c) {
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

double area(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    EXPECT_GT(area(points[a], points[b], points[c]), -kRounding) << "counter-clockwise";
    sum += area(points[a], points[b], points[c]);
  }
  return sum;
}

// The distance by which the deepest point lies inside a circumcircle; not positive for a Delaunay triangulation.
double deepest_inside(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : triangles) {
    const Point u{points[b][0] - points[a][0], points[b][1] - points[a][1]};
    const Point v{points[c][0] - points[a][0], points[c][1] - points[a][1]};
    const double d = 2 * (u[0] * v[1] - u[1] * v[0]), uu = u[0] * u[0] + u[1] * u[1], vv = v[0] * v[0] + v[1] * v[1];
    const Point centre{points[a][0] + (v[1] * uu - u[1] * vv) / d, points[a][1] + (u[0] * vv - v[0] * uu) / d};
    const double radius = std::hypot(centre[0] - points[a][0], centre[1] - points[a][1]);
    if (radius > 100) continue;  // nearly a line: its circle is not known to better than the rounding
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (p != a && p != b && p != c)
        deepest = std::max(deepest, radius - std::hypot(centre[0] - points[p][0], centre[1] - points[p][1]));
    }
  }
  return deepest;
}

std::vector<Point> random_points(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto next = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Point> points(count);
  for (Point& p : points) p = {next(), next()};
  return points;
}

TEST(Delaunay, LeavesNoPointInsideACircumcircle) {
  auto points = random_points(200, 1);
  for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) points.push_back(corner);
  const auto triangles = delaunay_triangles(points);
  // Euler: 2n − 2 − h triangles, where h = 4 points lie on the hull.
  EXPECT_EQ(triangles.size(), 2 * points.size() - 2 - 4);
  EXPECT_NEAR(area(points, triangles), 1, kRounding);
  EXPECT_LT(deepest_inside(points, triangles), kRounding);
}

TEST(Delaunay, CoversAGridWhoseCellsAreCocircular) {
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 6; ++k) points.push_back({0.1 * i, 0.1 * k});
  }
  const auto triangles = delaunay_triangles(points);
  EXPECT_EQ(triangles.size(), 2U * 8 * 5);
  EXPECT_NEAR(area(points, triangles), 0.8 * 0.5, kRounding);
}

TEST(Delaunay, IsEmptyOnALineAndForNumbersThatAreNotFinite) {
  EXPECT_TRUE(delaunay_triangles(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}).empty());
  EXPECT_TRUE(delaunay_triangles(std::vector<Point>{{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(delaunay_triangles(std::vector<Point>{{0, 0}, {0, 0}, {0, 0}}).empty());
  EXPECT_TRUE(delaunay_triangles(std::vector<Point>{{0, 0}, {1, std::nan("")}, {0, 1}}).empty());
  EXPECT_TRUE(delaunay_triangles(std::vector<Point>{{0, 0}, {1e308, 0}, {-1e308, 1}}).empty());
}

TEST(Delaunay, LeavesOutCoincidingPoints) {
  const auto triangles = delaunay_triangles(std::vector<Point>{{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 0}});
  ASSERT_EQ(triangles.size(), 1U);
  EXPECT_EQ((std::set<std::size_t>(triangles[0].begin(), triangles[0].end())), (std::set<std::size_t>{0, 1, 3}));
}

// Points within a rounding step of each other and of lines are the worst for floating-point predicates.
TEST(Delaunay, StaysATriangulationForNearlyDegeneratePoints) {
  std::vector<Point> points = random_points(150, 7);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][1] *= 1e-6;
    if (i % 3 == 0) points[i][0] = std::round(10 * points[i][0]) / 10;
  }
  points.push_back({0.5, 1});
  const auto triangles = delaunay_triangles(points);
  EXPECT_FALSE(triangles.empty());
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(edges.emplace(t.at(i), t.at((i + 1) % 3)).second) << "no edge twice in one direction";
    }
  }
}

TEST(SphereTriangles, CloseTheSphereAroundAllDirections) {
  std::vector<Direction> directions;
  for (int i = 0; i < 100; ++i) {  // a spiral of even spacing
    const double z = -0.99 + 0.02 * i, turn = 2.399963 * i, r = std::sqrt(1 - z * z);
    directions.push_back({3 * r * std::cos(turn), 3 * r * std::sin(turn), 3 * z});
  }
  const auto triangles = sphere_triangles(directions);
  EXPECT_EQ(triangles.size(), 2 * directions.size() - 4) << "Euler";
  double volume = 0;
  for (const auto& [a, b, c] : triangles) {
    const Direction &p = directions[a], &q = directions[b], &r = directions[c];
    volume +=
        (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) /
        6;
  }
  const double sphere = 4 * std::numbers::pi / 3 * 27;
  EXPECT_GT(volume, 0.9 * sphere) << "100 points fill a sphere to about 94 %";
  EXPECT_LT(volume, sphere);
}

TEST(SphereTriangles, CloseACubeWhoseFacesAreCoplanar) {
  std::vector<Direction> corners;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) corners.push_back({x, y, z});
    }
  }
  EXPECT_EQ(sphere_triangles(corners).size(), 12U);
}

TEST(SphereTriangles, AreEmptyInAPlaneAndForAZeroDirection) {
  EXPECT_TRUE(sphere_triangles(std::vector<Direction>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}).empty());
  EXPECT_TRUE(
      sphere_triangles(std::vector<Direction>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {-1, -1, -1}}).empty());
}

}  // namespace percuss::convex_hull_test
