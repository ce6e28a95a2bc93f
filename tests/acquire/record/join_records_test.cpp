#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquire/record/record.hpp"
#include "support/input_error.hpp"
#include "support/messages.hpp"
#include "support/record_samples.hpp"

namespace percuss::acquire::join_records_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

Record record_at(const std::string& path, std::vector<std::vector<double>> force_N, double fs_Hz = 100) {
  std::vector<std::vector<std::vector<double>>> accel_mps2;
  for (const auto& row : force_N) {
    accel_mps2.push_back({row});
    for (double& sample : accel_mps2.back().front()) sample *= 10;
  }
  Record record = record_in_memory(fs_Hz, std::move(force_N), std::move(accel_mps2));
  record.files = {{.path = path}};
  return record;
}

std::vector<int> points_of(const Record& record) {
  std::vector<int> points;
  for (const auto& row : record.rows) points.push_back(row.point);
  return points;
}

TEST(JoinRecords, ReturnsASingleRecordUnchanged) {
  Record one = record_at("a", {{1, 2}, {3, 4}});
  one.notes = {"as it was"};
  const Record joined = join_records({one}, FileGrouping::points);
  EXPECT_EQ(joined.notes, one.notes);
  EXPECT_EQ(joined.continuous, one.continuous);
  EXPECT_EQ(joined.rows.size(), 2U);
}

TEST(JoinRecords, KeepsEveryRowOfEveryFileInOrder) {
  const Record joined =
      join_records({record_at("a", {{1, 2}, {3, 4, 5}}), record_at("b", {{6, 7}})}, FileGrouping::automatic);
  ASSERT_EQ(joined.rows.size(), 3U);
  EXPECT_THAT(test::force_N(joined, 1), ElementsAre(3, 4, 5));
  EXPECT_THAT(test::force_N(joined, 2), ElementsAre(6, 7));
  EXPECT_THAT(test::accel_mps2(joined, 0, 2), ElementsAre(60, 70));
  EXPECT_EQ(joined.files.at(1).path, "b");
  EXPECT_EQ(joined.rows[1].file, 0U);
  EXPECT_EQ(joined.rows[2].file, 1U);
  EXPECT_THAT(points_of(joined), ElementsAre(0, 0, 0));
  EXPECT_FALSE(joined.continuous);
}

TEST(JoinRecords, SearchesForHitsWhereEachFileHasOneRow) {
  EXPECT_TRUE(join_records({record_at("a", {{1, 2}}), record_at("b", {{3, 4}})}, FileGrouping::hits).continuous);
}

TEST(JoinRecords, NumbersPointsByFile) {
  EXPECT_THAT(points_of(join_records({record_at("a", {{1}, {2}}), record_at("b", {{3}}), record_at("c", {{3}})},
                                     FileGrouping::points)),
              ElementsAre(0, 0, 1, 2));
  Record own = record_at("a", {{1}, {2}});
  own.rows[1].point = 4;
  EXPECT_THAT(points_of(join_records({own, record_at("b", {{3}})}, FileGrouping::points)), ElementsAre(0, 4, 5));
}

TEST(JoinRecords, RefusesPointNumbersThatBecomeTooLarge) {
  Record far = record_at("a", {{1}});
  far.rows[0].point = 1'000'000'000;
  EXPECT_THAT(input_error_of([&] {
                join_records({far, record_at("b", {{1}})}, FileGrouping::points);
              }),
              HasSubstr("1000000001 is not a point number (b)"));
  EXPECT_THAT(points_of(join_records({far, far, far}, FileGrouping::hits)),
              ElementsAre(1'000'000'000, 1'000'000'000, 1'000'000'000));
}

TEST(JoinRecords, NamesTheFileThatDiffers) {
  const std::string rates = input_error_of([] {
    join_records({record_at("a", {{1}}), record_at("b", {{1}}, 101)}, FileGrouping::hits);
  });
  EXPECT_THAT(rates, HasSubstr("sampling rate 101 Hz where a has 100 Hz (b)"));
  EXPECT_NO_THROW(join_records({record_at("a", {{1}}), record_at("b", {{1}}, 100 * (1 + 5e-7))}, FileGrouping::hits));
  Record two = record_at("b", {{1}});
  two.accel.push_back(two.accel.front());
  EXPECT_THAT(input_error_of([&] {
                join_records({record_at("a", {{1}}), two}, FileGrouping::hits);
              }),
              HasSubstr("2 acceleration channels where a has 1 (b)"));
  EXPECT_THAT(input_error_of([] { join_records({}, FileGrouping::hits); }), HasSubstr("nothing to join"));
}

TEST(JoinRecords, NotesChannelsWithOtherNames) {
  Record other = record_at("b", {{1}});
  other.accel.front().name = "top";
  other.notes = {"mind this"};
  EXPECT_THAT(test::texts(join_records({record_at("a", {{1}}), other}, FileGrouping::hits).notes),
              ElementsAre(HasSubstr("top of b"), "b: mind this"));
}

TEST(JoinRecords, StatesEachNoteOnce) {
  std::vector<Record> records;
  for (const char* path : {"a", "b", "c"}) records.push_back(record_at(path, {{1}}));
  for (Record& record : records) record.notes = {"of all"};
  records[1].notes.emplace_back("of two");
  records[2].notes.emplace_back("of two");
  EXPECT_THAT(test::texts(join_records(std::move(records), FileGrouping::hits).notes),
              ElementsAre("of all", "b and 1 more: of two"));
}

}  // namespace percuss::acquire::join_records_test
