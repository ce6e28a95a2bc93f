#include "acquire/record/point_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "acquire/record/frf_record.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"

namespace percuss::acquire::point_motion_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Direction kX{1, 0, 0}, kZ{0, 0, 1};

TEST(PointMotion, IsFoundByPointAndChannel) {
  std::vector<PointMotion> motions{{.point = 104, .place = 4, .along = kZ},
                                   {.point = 4, .channel = 1, .place = 4, .along = kZ},
                                   {.point = 4, .place = 4, .along = kX},
                                   {.point = 4, .place = 4, .along = kZ}};
  sort_motions(motions);
  ASSERT_EQ(motions.size(), 3U) << "the first of two statements counts";
  EXPECT_EQ(find_motion(motions, 4, 0)->along, kX);
  EXPECT_EQ(find_motion(motions, 4, 1)->along, kZ);
  EXPECT_EQ(find_motion(motions, 5, 0), nullptr);
  EXPECT_EQ(place_of_point(motions, 104), 4);
  EXPECT_EQ(place_of_point(motions, 7), 7);
  EXPECT_THAT(motions_at(motions, {1}), ElementsAre(PointMotion{.point = 4, .place = 4, .along = kZ}));
}

// A record of one hit on each of these points, which move along `along`.
Record record_of_points(const std::vector<int>& points, const Direction& along) {
  std::vector<std::vector<double>> force_N(points.size(), {1, 2});
  std::vector<std::vector<std::vector<double>>> accel_mps2(points.size(), {{3, 4}});
  Record record = record_in_memory(100, force_N, accel_mps2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    record.rows[i].point = points[i];
    record.motions.push_back({.point = points[i], .place = points[i], .along = along});
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  record.geometry = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {nan, nan, nan}};
  return record;
}

TEST(PointMotion, KeepsPlacesWhereFilesHoldOneDirectionEach) {
  const Record joined =
      join_records({record_of_points({0, 1, 2}, kX), record_of_points({0, 1, 2}, kZ)}, FileGrouping::points);
  EXPECT_EQ(find_motion(joined.motions, 4, 0)->along, kZ);
  EXPECT_EQ(place_of_point(joined.motions, 4), 1);
  const Record again =
      join_records({record_of_points({0, 1, 2}, kX), record_of_points({0, 1, 2}, kX)}, FileGrouping::points);
  EXPECT_EQ(place_of_point(again.motions, 4), 4) << "other points with the same numbers";
}

TEST(PointMotion, RefusesHitsInOtherDirectionsAtOnePoint) {
  EXPECT_THAT(test::input_error_of([] {
                join_records({record_of_points({0, 1}, kX), record_of_points({1, 2}, kZ)}, FileGrouping::hits);
              }),
              HasSubstr("another direction at point 1"));
  const Record joined = join_records({record_of_points({0, 1}, kX), record_of_points({1, 2}, kX)}, FileGrouping::hits);
  EXPECT_EQ(joined.motions.size(), 3U);
}

TEST(PointMotion, IsLeftOutWhereTheSensorsMovedInSomeFiles) {
  Record roving = record_of_points({0, 1}, kX);
  roving.sensor_roves = true;
  const Record joined = join_records({roving, record_of_points({2}, kZ)}, FileGrouping::hits);
  EXPECT_FALSE(joined.sensor_roves);
  EXPECT_THAT(joined.motions, ElementsAre(PointMotion{.point = 2, .place = 2, .along = kZ}));
  EXPECT_THAT(test::texts(joined.notes), ElementsAre(HasSubstr("the sensors moved in some files only")));
  EXPECT_TRUE(join_records({roving, roving}, FileGrouping::hits).sensor_roves);
}

TEST(PointMotion, IsJoinedWithFrfs) {
  FrfRecord one{.lines = {.fs_Hz = 8, .samples = 8, .first = 1, .count = 2}, .accel = {{.name = "accel 1"}}};
  one.frfs.push_back({.point = 3, .frf = {.value = {1, 2}}});
  one.motions.push_back({.point = 3, .place = 3, .along = kX});
  const FrfRecord joined = join_frfs({one, one});
  EXPECT_THAT(joined.motions, ElementsAre(PointMotion{.point = 3, .place = 3, .along = kX},
                                          PointMotion{.point = 7, .place = 7, .along = kX}));
  EXPECT_THAT(joined.notes, IsEmpty());
}

}  // namespace percuss::acquire::point_motion_test
