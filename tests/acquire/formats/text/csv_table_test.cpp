#include "acquire/formats/text/csv_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/parallel/parallel.hpp"
#include "support/files/csv_text.hpp"
#include "support/input_error.hpp"

namespace percuss::acquire::csv_table_test {

using test::input_error_of;
using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<CsvTable> table_of(const std::string& text) {
  const FileBytes bytes = test::csv_bytes(text);
  const char line_end = find_line_end(bytes.view());
  const auto probes = probe_lines(bytes.view(), line_end);
  const CsvDialect dialect = find_dialect(probes, line_end);
  const auto columns = find_number_columns(probes, dialect);
  return std::make_unique<CsvTable>(bytes, dialect, read_csv_header(bytes.view(), dialect, columns, "x.csv"), columns);
}

std::vector<double> column_of(const CsvTable& table, std::size_t index) {
  std::vector<double> numbers(table.lines());
  table.read(index, 0, numbers);
  return numbers;
}

TEST(CsvTable, ReadsOneColumnOfEveryDialect) {
  for (const char* text :
       {"a,b,c\n1,2.5,3\n4,5.5,6\n", "a,b,c\r\n1,2.5,3\r\n4,5.5,6\r\n", "a,b,c\r1,2.5,3\r4,5.5,6\r",
        "a;b;c\n1;2,5;3\n4;5,5;6", "a\tb\tc\n1\t2,5\t3\n4\t5,5\t6\n", "  a   b  c\n  1  2.5  3\n  4  5.5  6\n",
        "a,b,c\n\"1\",\"2.5\",\"3\"\n\"4\",\"5.5\",\"6\"\n", "a,b,c\n1, +2.5 ,3\n4,5.5D0,6\n",
        "# a\na,b,c\n\n1,2.5,3\n#,,\n\n4,5.5,6\n,,\n\n"}) {
    EXPECT_THAT(column_of(*table_of(text), 1), ElementsAre(2.5, 5.5)) << text;
  }
}

TEST(CsvTable, ReadsAnyRangeOfALongColumn) {
  std::string text = "a,b\n";
  constexpr std::size_t kLines = 10000;  // more than two blocks
  for (std::size_t i = 0; i < kLines; ++i) text += std::to_string(i) + ",-" + std::to_string(i) + "\n";
  const auto table = table_of(text);
  for (const auto& [first, count] :
       {std::pair<std::size_t, std::size_t>{4090, 10}, {0, 1}, {8191, 1809}, {9999, 1}, {10000, 0}}) {
    std::vector<double> numbers(count), expected(count);
    table->read(1, first, numbers);
    for (std::size_t i = 0; i < count; ++i) expected[i] = -static_cast<double>(first + i);
    EXPECT_EQ(numbers, expected) << first;
  }
}

TEST(CsvTable, IsReadByManyThreadsAtOnce) {
  std::string text = "a,b\n";
  for (int i = 0; i < 20000; ++i) text += "1,2\n";
  const auto table = table_of(text);
  std::vector<double> sums(16);
  parallel_for(sums.size(), 4, [&](std::size_t task) {
    const auto numbers = column_of(*table, task % 2);
    sums[task] = std::accumulate(numbers.begin(), numbers.end(), 0.0);
  });
  for (std::size_t task = 0; task < sums.size(); ++task) EXPECT_EQ(sums[task], task % 2 == 0 ? 20000 : 40000);
}

TEST(CsvTable, RefusesAGapOnlyInARangeThatIsRead) {
  const auto table = table_of("t,f,a\n0,1,2\n# note\n1,,3\n2,3,4\n");
  EXPECT_THAT(column_of(*table, 2), ElementsAre(2, 3, 4));
  EXPECT_EQ(input_error_of([&] { column_of(*table, 1); }),
            "an empty cell (x.csv: line 4, column 2 (f)); fill the gap or cut the file before it");
  // The failed block is not cached as read.
  EXPECT_THAT(input_error_of([&] { column_of(*table, 1); }), HasSubstr("line 4"));
}

TEST(CsvTable, NamesTheCellThatIsNotAFiniteNumber) {
  EXPECT_THAT(input_error_of([] { column_of(*table_of("t,f\n0,1\n1,nan\n2,3\n"), 1); }),
              HasSubstr("\"nan\" is not finite (x.csv: line 3, column 2 (f))"));
  EXPECT_THAT(input_error_of([] { column_of(*table_of("t,f\n0,1\n1,1e999\n2,3\n"), 1); }),
              HasSubstr("\"1e999\" is too large"));
  EXPECT_THAT(input_error_of([] { column_of(*table_of("t,f\n0,1\n1,over\n2,3\n"), 1); }),
              HasSubstr("\"over\" is not a number"));
  EXPECT_THAT(input_error_of([] { column_of(*table_of("0,1\n1,x\n2,3\n3,4\n"), 1); }), HasSubstr("line 2, column 2)"));
}

TEST(CsvTable, SkipsRepeatedLinesOfTheHeader) {
  std::string text, numbers;
  for (int i = 0; i < 100; ++i) text += "Setting " + std::to_string(i) + ",on\n";
  for (int i = 0; i < 500; ++i) numbers += std::to_string(i) + "," + std::to_string(i) + "\n";
  text += "t,f\ns,N\n\n" + numbers + "\nt,f\ns,N\n" + numbers + "t,f\n" + numbers;
  const auto table = table_of(text);
  const std::vector<double> column = column_of(*table, 1);
  ASSERT_EQ(column.size(), 1500U);
  for (std::size_t i = 0; i < column.size(); ++i) EXPECT_EQ(column[i], static_cast<double>(i % 500));
  EXPECT_THAT(table->lines_after_header(), ElementsAre(500, 1000));
  EXPECT_EQ(table->place(500), "x.csv: line 607") << "skipped lines count";
  EXPECT_EQ(table->cell(1, 1001), "1");
  // Another text than that of the header is an error, not a header.
  EXPECT_THAT(input_error_of([] { column_of(*table_of("t,f\n0,1\n1,2\nt,F\n2,3\n"), 1); }),
              HasSubstr("\"F\" is not a number (x.csv: line 4"));
}

TEST(CsvTable, RefusesLinesOfAnotherLength) {
  EXPECT_THAT(input_error_of([] { table_of("t,f,a\n0,1,2\n1,2\n2,3,4\n3,3,4\n"); }),
              HasSubstr("2 columns where 3 are expected (x.csv: line 3)"));
  EXPECT_THAT(input_error_of([] { table_of("t,f,a\n0,1,2\n1,2,3,4\n2,3,4\n3,3,4\n"); }),
              HasSubstr("4 columns where 3 are expected (x.csv: line 3)"));
  EXPECT_EQ(table_of("t,f,a\n0,1,2,,\n1,2,3\n2,3,4,\n")->lines(), 3U);
}

TEST(CsvTable, RefusesALineOfMoreThanOneMebibyte) {
  const std::string text = "t,f\n0,1\n1," + std::string((std::size_t{1} << 20U) + 1, '1') + "\n2,3\n3,4\n";
  EXPECT_THAT(input_error_of([&] { table_of(text); }), HasSubstr("line of more than 1 MiB"));
}

}  // namespace percuss::acquire::csv_table_test
