#include "pipeline/survey_geometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "support/input_error.hpp"

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
  const MatchedPoints matched = match_point_numbers(geometry, {0, 1, 2});
  ASSERT_EQ(matched.warnings.size(), 1U);
  EXPECT_EQ(matched.warnings.front().code, "points_from_one");
  EXPECT_EQ(matched.stated.at(0), 1);
  EXPECT_EQ(geometry.points.front().point, 0);
  EXPECT_THAT(geometry.lines.front(), ElementsAre(0, 1));
  EXPECT_THAT(geometry.faces.front(), ElementsAre(0, 1, 2));
}

TEST(SurveyGeometry, StaysWhereItsNumbersFit) {
  for (const std::set<int>& measured : std::vector<std::set<int>>{{1, 2}, {1, 2, 3}, {0, 7}}) {
    acquire::Geometry geometry = triangle(1);
    EXPECT_THAT(match_point_numbers(geometry, measured).warnings, IsEmpty());
    EXPECT_EQ(geometry.points.front().point, 1);
  }
}

TEST(SurveyGeometry, SaysThatItsUnitIsAssumed) {
  acquire::Geometry geometry = triangle(0);
  geometry.unit_assumed = true;
  const auto warnings = match_point_numbers(geometry, {0, 1, 2}).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().code, "geometry_unit_assumed");
}

TEST(SurveyGeometry, NamesPointsWithoutMeasurement) {
  EXPECT_THAT(missing_points(triangle(0), {0, 1, 2}, {}, 1), IsEmpty());
  const auto warnings = missing_points(triangle(0), {0, 2}, {}, 3);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings.front().message, testing::StartsWith("1 of the geometry's 3 points were not measured: 1;"));
  EXPECT_EQ(warnings.front().severity, warnings::Severity::warn) << "a missing file moves all later points";
  // The order of files explains nothing where one file states its points.
  EXPECT_EQ(missing_points(triangle(0), {0, 2}, {}, 1).at(0).message,
            "1 of the geometry's 3 points were not measured: 1");
}

// P2.csv is missing: P3.csv is point 3, not point 2. The order of the files does not matter.
TEST(SurveyGeometry, TakesTheNumbersInTheNamesOfFiles) {
  for (const auto& [files, first, last] : {std::tuple{std::vector<std::string>{"P1.csv", "P3.csv"}, 0, 1},
                                           std::tuple{std::vector<std::string>{"P3.csv", "P1.csv"}, 1, 0}}) {
    acquire::Geometry geometry = triangle(1);
    const MatchedPoints matched = match_point_numbers(geometry, {0, 1}, files);
    EXPECT_EQ(matched.numbers, GeometryNumbers::file_names);
    EXPECT_THAT(matched.warnings, IsEmpty());
    EXPECT_EQ(geometry.points[0].point, first) << "the place of P1";
    EXPECT_EQ(geometry.points[1].point, 2) << "not measured";
    EXPECT_EQ(geometry.points[2].point, last) << "the place of P3";
    EXPECT_THAT(geometry.lines.front(), ElementsAre(first, 2));
    EXPECT_THAT(geometry.faces.front(), ElementsAre(first, 2, last));
    EXPECT_NO_THROW(require_points(geometry, {0, 1}, "geo.csv", matched, files));
    const auto missing = missing_points(geometry, {0, 1}, matched, files.size());
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_FALSE(missing.front().severity.has_value()) << "as ranked: info";
    EXPECT_EQ(missing.front().message,
              "1 of the geometry's 3 points were not measured: 2; each file is the point of the number in its name");
  }
}

TEST(SurveyGeometry, TakesTheNumbersInTheNamesThatItHas) {
  acquire::Geometry geometry = triangle(1);
  const std::vector<std::string> files{"M151_P1.csv", "M157_P3.csv"};
  const MatchedPoints matched = match_point_numbers(geometry, {0, 1}, files);
  EXPECT_EQ(matched.numbers, GeometryNumbers::file_names);
  EXPECT_THAT(matched.warnings, IsEmpty());
  EXPECT_EQ(geometry.points[2].point, 1) << "the place of P3";
  EXPECT_EQ(missing_points(geometry, {0, 1}, matched, files.size()).at(0).message,
            "1 of the geometry's 3 points were not measured: 2; each file is the point of the number in its name");
}

TEST(SurveyGeometry, RefusesAFileWhoseNumberItLacks) {
  const std::vector<std::string> files{"a/P1.csv", "a/P2.csv", "a/P4.csv"};
  acquire::Geometry geometry = triangle(1);
  const MatchedPoints matched = match_point_numbers(geometry, {0, 1, 2}, files);
  EXPECT_EQ(matched.numbers, GeometryNumbers::contradicted);
  EXPECT_EQ(test::input_error_of([&] {
              require_points(geometry, {0, 1, 2}, "geo.csv", matched, files);
            }),
            "the geometry lacks point 4, the number in the name of P4.csv (geo.csv); add it, or name the files by the "
            "geometry's numbers; to take the files in their order, join them to one record first");
}

TEST(SurveyGeometry, SaysThatFilesOfOtherNumbersAreTakenInOrder) {
  acquire::Geometry geometry = triangle(1);
  const auto warnings = match_point_numbers(geometry, {0, 1, 2}, {"t_101502", "t_101640", "t_101733"}).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.front().code, "files_in_order");
  EXPECT_THAT(warnings.front().message, testing::HasSubstr("t_101502 is point 1"));
}

TEST(SurveyGeometry, SaysThatEachFileIsTakenAsAPoint) {
  const std::vector<std::string> files{"a.csv", "b.csv", "c.csv", "d.csv"};
  acquire::Geometry geometry = triangle(1);
  const MatchedPoints matched = match_point_numbers(geometry, {0, 1, 2, 3}, files);
  EXPECT_THAT(test::input_error_of([&] {
                require_points(geometry, {0, 1, 2, 3}, "geo.csv", matched, files);
              }),
              testing::HasSubstr("lacks point 4: each of the 4 files is taken as a point, and d.csv is point 4"));
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
