#include "pipeline/radial_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percuss::pipeline::radial_shape_test {

using acquire::PointMotion;
using std::numbers::pi;

constexpr double kRounding = 1e-12;

// A ring of eight points around x, and the shape cos 2θ along the normals.
acquire::Geometry ring() {
  acquire::Geometry geometry{.points = {}, .tube = true};
  for (int p = 0; p < 8; ++p) geometry.points.push_back({.point = p, .angle_rad = p * pi / 4});
  return geometry;
}
double radial_at(int point) { return std::cos(2 * point * pi / 4); }

// The radial motion at each place, as sensors along the directions of `motions` measure it.
identify::ModeShape seen_along(const std::vector<PointMotion>& motions) {
  identify::ModeShape shape;
  for (const PointMotion& motion : motions) {
    const double angle_rad = motion.place * pi / 4;
    const double cosine = motion.along->at(1) * std::cos(angle_rad) + motion.along->at(2) * std::sin(angle_rad);
    shape.places.push_back(
        {.point = static_cast<std::size_t>(motion.point), .value = cosine * radial_at(motion.place), .std = 0.1});
  }
  return shape;
}

TEST(RadialShape, TakesTheSignOfRadialDirections) {
  std::vector<PointMotion> motions;
  for (int p = 0; p < 8; p += 2) {  // along +y and +z at 0°, 90°, 180° and 270°
    const acquire::Direction along{0, p % 4 == 0 ? 1.0 : 0.0, p % 4 == 0 ? 0.0 : 1.0};
    motions.push_back({.point = p, .place = p, .along = along});
  }
  const identify::ModeShape found = radial_shape(seen_along(motions), motions, ring());
  ASSERT_EQ(found.places.size(), 4U);
  for (const identify::ShapePlace& place : found.places)
    EXPECT_NEAR(place.value.real(), radial_at(static_cast<int>(place.point)), kRounding) << place.point;
}

TEST(RadialShape, CombinesTheDirectionsOfAPlace) {
  std::vector<PointMotion> motions;
  for (int p = 0; p < 8; ++p) {
    motions.push_back({.point = p, .place = p, .along = acquire::Direction{1, 0, 0}});
    motions.push_back({.point = 10 + p, .place = p, .along = acquire::Direction{0, 1, 0}});
    motions.push_back({.point = 20 + p, .place = p, .along = acquire::Direction{0, 0, 1}});
  }
  acquire::sort_motions(motions);
  const identify::ModeShape found = radial_shape(seen_along(motions), motions, ring());
  ASSERT_EQ(found.places.size(), 8U);
  for (const identify::ShapePlace& place : found.places) {
    EXPECT_NEAR(place.value.real(), radial_at(static_cast<int>(place.point)), kRounding) << place.point;
    EXPECT_NEAR(place.std, 0.1, kRounding) << "sin² + cos² = 1";
  }
}

// A disc struck along its axis has the same circumferential orders.
TEST(RadialShape, KeepsAPatternAlongOneLine) {
  std::vector<PointMotion> motions;
  identify::ModeShape shape;
  for (int p = 0; p < 8; ++p) {
    motions.push_back({.point = p, .place = p, .along = acquire::Direction{1, 0, 0}});
    shape.places.push_back({.point = static_cast<std::size_t>(p), .value = radial_at(p), .std = 0.1});
  }
  const identify::ModeShape found = radial_shape(shape, motions, ring());
  ASSERT_EQ(found.places.size(), 8U);
  for (const identify::ShapePlace& place : found.places)
    EXPECT_EQ(place.value.real(), radial_at(static_cast<int>(place.point)));
}

TEST(RadialShape, LeavesOutPlacesThatMoveAcrossTheNormal) {
  const std::vector<PointMotion> motions{{.point = 0, .place = 0, .along = acquire::Direction{0, 1, 0}},
                                         {.point = 2, .place = 2, .along = acquire::Direction{1, 0, 0}}};
  identify::ModeShape shape;
  shape.places = {{.point = 0, .value = 2.0}, {.point = 2, .value = 3.0}, {.point = 4, .value = 4.0}};
  const identify::ModeShape found = radial_shape(shape, motions, ring());
  ASSERT_EQ(found.places.size(), 2U);
  EXPECT_EQ(found.places[0].point, 0U);
  EXPECT_EQ(found.places[1].point, 4U) << "without a direction, it is radial";
}

}  // namespace percuss::pipeline::radial_shape_test
