#include "acquire/channels/csv_columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::acquire::csv_columns_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

CsvHeader header_of(const std::vector<std::string>& names) {
  CsvHeader header{.named = true};
  for (const auto& name : names) {
    const auto [base, unit] = split_name(name);
    header.columns.push_back({.index = header.columns.size(), .name = name, .base = base, .unit = unit});
  }
  return header;
}

CsvColumns columns_of(const std::vector<std::string>& names, const ReadOptions& options = {}) {
  return find_csv_columns(header_of(names), options, "x.csv");
}

std::vector<std::string> accel_names(const CsvColumns& columns) {
  std::vector<std::string> names;
  for (const auto& column : columns.accel) names.push_back(column.name);
  return names;
}

TEST(CsvColumns, AreFoundByTheirUnits) {
  const auto columns = columns_of({"a (s)", "b (lbf)", "c (g)", "d (V)", "e (cm/s2)"});
  EXPECT_EQ(columns.time->name, "a (s)");
  EXPECT_EQ(columns.force.name, "b (lbf)");
  EXPECT_THAT(accel_names(columns), ElementsAre("c (g)", "e (cm/s2)"));
}

TEST(CsvColumns, AreFoundByWordsInTheirNames) {
  const auto columns = columns_of({"Run", "HIT", "Time", "Impact Hammer", "ACC top", "accel_2", "temperature"});
  EXPECT_EQ(columns.run->index, 0U);
  EXPECT_EQ(columns.hit->index, 1U);
  EXPECT_EQ(columns.time->index, 2U);
  EXPECT_EQ(columns.force.name, "Impact Hammer");
  EXPECT_THAT(accel_names(columns), ElementsAre("ACC top", "accel_2"));
}

TEST(CsvColumns, PreferTheUnitToTheName) {
  const auto columns = columns_of({"t", "hammer acceleration (g)", "force (N)"});
  EXPECT_EQ(columns.force.name, "force (N)");
  EXPECT_THAT(accel_names(columns), ElementsAre("hammer acceleration (g)"));
}

TEST(CsvColumns, FollowTheOptions) {
  const std::vector<std::string> names = {"t_s", "CH2", "CH3", "CH8"};
  auto columns = columns_of(names, {.force_channel = "ch8", .accel_channels = {"3", "CH2"}});
  EXPECT_EQ(columns.force.index, 3U);
  EXPECT_THAT(accel_names(columns), ElementsAre("CH3", "CH2"));
  columns = columns_of({"Force (N)", "Other (N)", "Acc (g)"}, {.force_channel = "other"});
  EXPECT_EQ(columns.force.index, 1U);
}

TEST(CsvColumns, FollowTheSetUpsRoles) {
  ReadOptions options;
  options.setup = {
      {.name = "CH8", .role = "force"}, {.name = "2", .role = "acceleration"}, {.name = "acc", .role = "ignore"}};
  const auto columns = columns_of({"t_s", "CH2", "acc (g)", "CH8"}, options);
  EXPECT_EQ(columns.force.name, "CH8");
  EXPECT_THAT(accel_names(columns), ElementsAre("CH2"));
}

TEST(CsvColumns, ListTheColumnsWhenNoneFits) {
  EXPECT_EQ(input_error_of([] {
              columns_of({"t_s", "CH2 [cm/s2]", "CH8 [V]"});
            }),
            "no force column found among t_s, CH2 [cm/s2], CH8 [V] (x.csv: header); name the force");
  EXPECT_THAT(input_error_of([] {
                columns_of({"t_s", "force_N", "CH8"});
              }),
              HasSubstr("no acceleration column found among t_s, force_N, CH8"));
  EXPECT_THAT(input_error_of([] {
                columns_of({"a_N", "b_N", "c_g"});
              }),
              HasSubstr("2 columns could be the force: a_N, b_N"));
}

TEST(CsvColumns, RefuseVelocitiesInPlaceOfAccelerations) {
  EXPECT_THAT(input_error_of([] {
                columns_of({"t (s)", "force (N)", "laser (mm/s)"});
              }),
              HasSubstr("laser (mm/s) is a velocity"));
  EXPECT_THAT(accel_names(columns_of({"t (s)", "force (lbs)", "laser (mm/s)", "a (g)"})), ElementsAre("a (g)"));
}

TEST(CsvColumns, RefuseNamesThatAreMissingOrDoubled) {
  const std::vector<std::string> names = {"t_s", "f", "a", "A"};
  EXPECT_THAT(input_error_of([&] { columns_of(names, {.force_channel = "x"}); }),
              HasSubstr("no column \"x\" among t_s, f, a, A"));
  EXPECT_THAT(input_error_of([&] { columns_of(names, {.force_channel = "5"}); }), HasSubstr("no column \"5\""));
  const auto ambiguous = [&] { columns_of(names, {.force_channel = "f", .accel_channels = {"a"}}); };
  EXPECT_THAT(input_error_of(ambiguous), HasSubstr("give its number, for instance 3"));
  EXPECT_THAT(test::options_of_error(ambiguous), ElementsAre("accel_channel"));
  EXPECT_THAT(input_error_of([&] { columns_of(names, {.force_channel = "f", .accel_channels = {"2"}}); }),
              HasSubstr("named twice"));
  EXPECT_THAT(input_error_of([&] {
                columns_of(names, {.force_channel = "f", .accel_channels = {"3", "3"}});
              }),
              HasSubstr("named twice"));
}

}  // namespace percuss::acquire::csv_columns_test
