#include "pipeline/survey_geometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::pipeline::survey_geometry_test {

using testing::ElementsAre;
using testing::IsEmpty;

acquire::Geometry triangle(int first) {
  acquire::Geometry out;
  for (int i = 0; i < 3; ++i) out.points.push_back({.point = first + i, .xyz_m = std::array<double, 3>{1.0 * i, 0, 0}});
  out.lines = {{first, first + 1}};
  out.faces = {{first, first + 1, first + 2}};
  return out;
}

TEST(SurveyGeometry, CountsFromZeroWithItsLinesAndFaces) {
  acquire::Geometry geometry = triangle(1);
  const auto warnings = match_point_numbers(geometry, {0, 1, 2});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().code, "points_from_one");
  EXPECT_EQ(geometry.points.front().point, 0);
  EXPECT_THAT(geometry.lines.front(), ElementsAre(0, 1));
  EXPECT_THAT(geometry.faces.front(), ElementsAre(0, 1, 2));
}

TEST(SurveyGeometry, StaysWhereItsNumbersFit) {
  for (const std::set<int>& measured : std::vector<std::set<int>>{{1, 2}, {1, 2, 3}, {0, 7}}) {
    acquire::Geometry geometry = triangle(1);
    EXPECT_THAT(match_point_numbers(geometry, measured), IsEmpty());
    EXPECT_EQ(geometry.points.front().point, 1);
  }
}

TEST(SurveyGeometry, SaysThatItsUnitIsAssumed) {
  acquire::Geometry geometry = triangle(0);
  geometry.unit_assumed = true;
  const auto warnings = match_point_numbers(geometry, {0, 1, 2});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().code, "geometry_unit_assumed");
}

TEST(SurveyGeometry, NamesPointsWithoutMeasurement) {
  EXPECT_THAT(missing_points(triangle(0), {0, 1, 2}, 1), IsEmpty());
  const auto warnings = missing_points(triangle(0), {0, 2}, 3);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings.front().message, testing::StartsWith("1 of the geometry's 3 points were not measured: 1;"));
  // The order of files explains nothing where one file states its points.
  EXPECT_EQ(missing_points(triangle(0), {0, 2}, 1).at(0).message, "1 of the geometry's 3 points were not measured: 1");
}

// "Add point 0" would shift all other points by one.
TEST(SurveyGeometry, NamesTheMissingPointInTheNumbersOfTheGeometry) {
  acquire::Geometry from_one;
  for (int point = 1; point <= 19; ++point) from_one.points.push_back({.point = point});
  std::set<int> measured;
  for (int point = 0; point < 20; ++point) measured.insert(point);
  try {
    require_points(from_one, measured, "geo.csv");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("point 20 if the geometry numbers its points from 1"));
  }
  EXPECT_THROW(require_points(triangle(0), {0, 1, 7}, "geo.csv"), InputError);
  EXPECT_NO_THROW(require_points(triangle(0), {0, 2}, "geo.csv"));
}

// Angles of 0 to 2π read as degrees. Points on one line along the tube, and points all around it, are plausible.
TEST(SurveyGeometry, DoubtsAnglesThatHardlyDiffer) {
  const auto warned = [](double range_rad) {
    acquire::Geometry tube{.points = {}, .tube = true};
    for (int i = 0; i < 4; ++i) tube.points.push_back({.point = i, .angle_rad = range_rad * i / 3.0});
    return narrow_arc(tube).size();
  };
  EXPECT_EQ(warned(0), 0U);
  EXPECT_EQ(warned(4.7 * 0.0175), 1U);
  EXPECT_EQ(warned(4.7), 0U);
  EXPECT_THAT(narrow_arc(triangle(0)), IsEmpty());
}

}  // namespace percuss::pipeline::survey_geometry_test
