#include "pipeline/stated_driving_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::pipeline::stated_driving_points_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const std::set<int> kFour{0, 1, 2, 3};
const std::vector<std::string> kFromOne{"plate/P1.csv", "plate/P2.csv", "plate/P3.csv", "plate/P4.csv"};
const std::vector<std::string> kFromZero{"plate/P0.csv", "plate/P1.csv", "plate/P2.csv", "plate/P3.csv"};
const std::vector<std::string> kWords{"plate/corner.csv", "plate/edge.csv", "plate/middle.csv", "plate/tip.csv"};

std::size_t point_of(const StatedDrivingPoint& stated, const PointNumbering& numbering) {
  return driving_points_of({stated}, numbering, "plate").points.at(0).point;
}

TEST(StatedDrivingPoints, TakeTheNumberInTheNameOfAFile) {
  const PointNumbering numbering{.points = kFour, .files = kFromOne};
  for (int number = 1; number <= 4; ++number)
    EXPECT_EQ(point_of({.point = number}, numbering), static_cast<std::size_t>(number - 1));
  EXPECT_EQ(point_of({.point = 0}, numbering), 0U) << "no file has this number: it is that of the results";
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour, .files = kFromOne, .geometry_from_one = true}), 2U);
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour, .files = kFromZero, .geometry_from_one = true}), 3U);
}

TEST(StatedDrivingPoints, TakeTheNumberOfAGeometryWhereFilesHaveNone) {
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour, .files = kWords}), 3U);
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour, .files = kWords, .geometry_from_one = true}), 2U);
  EXPECT_EQ(point_of({.point = 4}, {.points = kFour, .files = kWords, .geometry_from_one = true}), 3U);
}

TEST(StatedDrivingPoints, TakeTheNumberThatTheRecordStates) {
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour}), 3U);
  EXPECT_EQ(point_of({.point = 3}, {.points = kFour, .geometry_from_one = true}), 3U);
}

TEST(StatedDrivingPoints, TakeTheNameOfAFile) {
  const PointNumbering numbering{.points = kFour, .files = kFromOne, .geometry_from_one = true};
  for (const char* name : {"P3", "P3.csv", "plate/P3.csv"}) {
    const DrivingPoints found = driving_points_of({{.file = name, .channel = 1}}, numbering, "plate");
    EXPECT_EQ(found.points.at(0).point, 2U) << name;
    EXPECT_EQ(found.points.at(0).channel, 1U);
    EXPECT_THAT(found.warnings, IsEmpty()) << "a name has one meaning";
  }
}

TEST(StatedDrivingPoints, WarnOfNumbersWithSeveralMeanings) {
  const auto warned = [](int point, const PointNumbering& numbering) {
    const auto found = driving_points_of({{.point = point}}, numbering, "plate").warnings;
    return found.empty() ? std::string() : found.at(0).code + ": " + found.at(0).message;
  };
  EXPECT_EQ(
      warned(3, {.points = kFour, .files = kFromOne, .geometry_from_one = true}),
      "driving_point_numbers: driving point 3 is taken as P3.csv, by the numbers in the files' names; point 3 of "
      "the results, which count from 0, is P4.csv. If that one is meant, modal masses and the scale of the shapes "
      "are wrong; name the file to be sure: P3.csv:0");
  EXPECT_THAT(
      warned(3, {.points = kFour, .files = kFromZero, .geometry_from_one = true}),
      AllOf(HasSubstr("is taken as P3.csv"), HasSubstr("point 3 of the geometry, which counts from 1, is P2.csv")));
  EXPECT_THAT(
      warned(3, {.points = kFour, .geometry_from_one = true}),
      AllOf(HasSubstr("taken as point 3 of the record, 4 of the geometry; point 3 of the geometry, which counts "
                      "from 1, is point 2 of the record, 3 of the geometry"),
            HasSubstr("number the geometry as the record")));
  EXPECT_EQ(warned(4, {.points = kFour, .files = kFromOne}), "") << "the results have no point 4";
  EXPECT_EQ(warned(3, {.points = kFour, .files = kFromZero}), "");
  EXPECT_EQ(warned(3, {.points = kFour}), "");
}

TEST(StatedDrivingPoints, RefuseWhatIsNoPoint) {
  const auto refusal = [](const StatedDrivingPoint& stated, const PointNumbering& numbering) {
    return test::input_error_of([&] { driving_points_of({stated}, numbering, "plate"); });
  };
  EXPECT_THAT(refusal({.point = 9}, {.points = kFour, .files = kFromOne}),
              AllOf(HasSubstr("point 9 was not measured"), HasSubstr("choose from points 1 to 4")));
  EXPECT_THAT(refusal({.file = "P9"}, {.points = kFour, .files = kFromOne}), HasSubstr("no point has the file \"P9\""));
  EXPECT_THAT(refusal({.file = "P9"}, {.points = kFour}), HasSubstr("no file \"P9\" is a point of its own"));
  EXPECT_THAT(refusal({.file = "P1"}, {.points = {0, 1}, .files = {"a/P1.csv", "b/P1.csv"}}),
              HasSubstr("2 points have a file \"P1\""));
}

}  // namespace percuss::pipeline::stated_driving_points_test
