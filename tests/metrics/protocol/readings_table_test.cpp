#include "metrics/protocol/readings_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::metrics::readings_table_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadingsTable, ReadsItsExample) {
  const auto rows = parse_readings_table(readings_table_example(), "t");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].id, "W1");
  EXPECT_EQ(rows[0].properties.at("material"), "wood");
  EXPECT_EQ(rows[0].readings.length_in, 33);
  EXPECT_THAT(rows[0].readings.periods_s, ElementsAre(1.388, 1.389));
  EXPECT_EQ(rows[2].readings.out_mph, 28.6);
}

TEST(ReadingsTable, TakesMissingReadingsFromTheCommonOnes) {
  LabReadings common{.ball_g = 145.4, .z_in = 6, .in_mph = 136};
  common.periods_s = {1.4};
  const auto rows = parse_readings_table("id,z_in,moi_oz_in2,besr\na,5.5,9600,\nb,,,0.7\n", "t", common);
  EXPECT_EQ(rows[0].readings.z_in, 5.5);
  EXPECT_EQ(rows[0].readings.ball_g, 145.4);
  EXPECT_TRUE(rows[0].readings.periods_s.empty());  // the row's moment of inertia replaces the pendulum
  EXPECT_EQ(rows[1].readings.z_in, 6);
  EXPECT_THAT(rows[1].readings.periods_s, ElementsAre(1.4));
}

TEST(ReadingsTable, RejectsImpossibleRows) {
  for (const auto& [text, problem] : std::vector<std::pair<std::string, std::string>>{
           {"id,length_in\na,33\na,34\n", "is in two rows"},
           {"id,length_in\na,3\n", "line 2"},
           {"id,weight_oz\na,-1\n", "line 2"},
           {"id,colour\na,red\n", "colour"},
           {"length_in\n33\n", "id"},
           {"id\n", "no bats"},
           {"id,diameter_in\na,1 2 3 4 5 6 7 8\n", "more than 7 values"},
           {"id,hoop1_hz\na,0\n", "hoop1_hz"},
           {R"({"schema": "percuss/session/1", "bats": []})", "not a table of readings"}})
    EXPECT_THAT(input_error_of([&, &table = text] { parse_readings_table(table, "t"); }), HasSubstr(problem)) << text;
}

}  // namespace percuss::metrics::readings_table_test
