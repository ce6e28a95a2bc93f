#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire::select_rows_test {

Record three_rows() { return record_in_memory(1000, {{1, 2}, {3, 4}, {5, 6}}, {{{7, 8}}, {{9, 10}}, {{11, 12}}}); }

Record odd_rows(const Record& record) {
  return select_rows(record, [n = 0](const RowInfo&) mutable { return n++ % 2 == 1; });
}

TEST(SelectRows, ReadsTheSamplesOfTheRowsThatAreKept) {
  const Record one = odd_rows(three_rows());
  ASSERT_EQ(one.rows.size(), 1U);
  double force = 0, accel = 0;
  one.read_force_N(0, 1, std::span(&force, 1));
  one.read_accel_mps2(0, 0, 1, std::span(&accel, 1));
  EXPECT_EQ(force, 4);
  EXPECT_EQ(accel, 10);
}

// Record::contiguous states the place of the first row of the file.
TEST(SelectRows, StatesNoPlacesInTheFile) {
  Record record = three_rows();
  record.contiguous = {{.offset_bytes = 100}, {.offset_bytes = 200}};
  EXPECT_TRUE(odd_rows(record).contiguous.empty());
  EXPECT_TRUE(join_records({record, record}, FileGrouping::hits).contiguous.empty());
}

TEST(SelectRows, ViewsSamplesInMemoryWithoutACopy) {
  const Record all = three_rows();
  const Record one = odd_rows(all);
  std::vector<double> buffer;
  EXPECT_EQ(one.read_force_N.view_or_read(0, 0, 2, buffer).data(),
            all.read_force_N.view_or_read(1, 0, 2, buffer).data());
  EXPECT_EQ(one.read_accel_mps2.view_or_read(0, 0, 0, 2, buffer).data(),
            all.read_accel_mps2.view_or_read(1, 0, 0, 2, buffer).data());
  EXPECT_TRUE(buffer.empty());
}

}  // namespace percuss::acquire::select_rows_test
