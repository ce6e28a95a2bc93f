#include "acquire/record/writable_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_error.hpp"

namespace percuss::acquire::writable_record_test {

using test::input_error_of;
using testing::HasSubstr;

Record with_rows(const std::vector<std::size_t>& samples) {
  Record record;
  record.accel.emplace_back();
  for (const std::size_t count : samples) {
    record.rows.emplace_back();
    record.rows.back().samples = count;
  }
  return record;
}

TEST(WritableRecord, HasAHitAndAChannel) {
  const Record empty = with_rows({});
  Record silent = with_rows({100});
  silent.accel.clear();
  EXPECT_THAT(input_error_of([&] { require_contents(empty, "t.uff"); }), HasSubstr("no hits to write (t.uff)"));
  EXPECT_THAT(input_error_of([&] { require_contents(silent, "t.uff"); }),
              HasSubstr("no acceleration to write (t.uff)"));
  EXPECT_THAT(input_error_of([&] { require_equal_lengths(empty, "t.mat"); }), HasSubstr("no hits to write"));
  EXPECT_NO_THROW(require_contents(with_rows({100, 99}), "t.uff"));
}

TEST(WritableRecord, HasHitsOfOneLengthInAMatrix) {
  EXPECT_NO_THROW(require_equal_lengths(with_rows({100, 100}), "t.mat"));
  EXPECT_THAT(input_error_of([&] {
                require_equal_lengths(with_rows({100, 100, 99}), "t.mat");
              }),
              HasSubstr("hits differ in length: 100 and 99 samples (t.mat); write them as CSV or UFF"));
}

}  // namespace percuss::acquire::writable_record_test
