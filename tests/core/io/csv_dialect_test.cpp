#include "core/io/csv_dialect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::csv_dialect_test {

using testing::ElementsAre;

CsvDialect dialect_of(std::string_view text) {
  const char line_end = find_line_end(text);
  return find_dialect(probe_lines(text, line_end), line_end);
}

TEST(CsvDialect, IsFoundFromTheLinesOfNumbers) {
  EXPECT_EQ(dialect_of("a,b\n0.5,1\n0.6,2\n").delimiter, ',');
  EXPECT_EQ(dialect_of("a;b\n0.5;1\n0.6;2\n").delimiter, ';');
  EXPECT_EQ(dialect_of("a\tb\n0.5\t1\n0.6\t2\n").delimiter, '\t');
  EXPECT_EQ(dialect_of("  a  b\n  0.5    1\n  0.6    2\n").delimiter, ' ');
}

TEST(CsvDialect, HasADecimalCommaBesideAnotherDelimiter) {
  for (const char* text : {"a;b\n0,5;1\n0,6;2\n", "a\tb\n0,5\t1\n0,6\t2\n", "0,5 1,5\n0,6 2,5\n"}) {
    const CsvDialect dialect = dialect_of(text);
    EXPECT_TRUE(dialect.decimal_comma) << text;
    EXPECT_NE(dialect.delimiter, ',') << text;
  }
  EXPECT_FALSE(dialect_of("0.5;1\n0.6;2\n").decimal_comma);
}

TEST(CsvDialect, HasACommaWithBlanksAsDelimiter) {
  EXPECT_EQ(dialect_of("0, 15, 20\n1, 16, 21\n").delimiter, ',');
  EXPECT_EQ(dialect_of("0 ,15 ,20\n1 ,16 ,21\n").delimiter, ',');
  EXPECT_FALSE(dialect_of("0, 15, 20\n1, 16, 21\n").decimal_comma);
}

TEST(CsvDialect, HasDecimalCommasInsideQuotes) {
  const CsvDialect dialect = dialect_of("a,b\n\"0,5\",\"1\"\n\"0,6\",\"2\"\n");
  EXPECT_EQ(dialect.delimiter, ',');
  EXPECT_TRUE(dialect.decimal_comma);
  EXPECT_TRUE(dialect.quoted);
}

TEST(CsvDialect, FindsEveryKindOfLineEnd) {
  EXPECT_EQ(find_line_end("a\nb"), '\n');
  EXPECT_EQ(find_line_end("a\r\nb"), '\n');
  EXPECT_EQ(find_line_end("a\rb"), '\r');
  std::string_view rest = "a\r\n\r\nb";
  EXPECT_EQ(take_line(rest, '\n'), "a");
  EXPECT_EQ(take_line(rest, '\n'), "");
  EXPECT_EQ(take_line(rest, '\n'), "b");
  EXPECT_TRUE(rest.empty());
}

TEST(CsvDialect, SplitsCellsAtTheDelimiter) {
  EXPECT_THAT(split_cells("a, \"b,c\" ,,", {}), ElementsAre("a", "b,c", "", ""));
  EXPECT_THAT(split_cells("", {}), ElementsAre(""));
  EXPECT_THAT(split_cells("  a   b\t c ", {.delimiter = ' '}), ElementsAre("a", "b", "c"));
  EXPECT_THAT(split_cells("   ", {.delimiter = ' '}), ElementsAre());
  EXPECT_THAT(split_cells("\"unclosed,b", {}), ElementsAre("\"unclosed,b"));
  EXPECT_THAT(split_cells("a,b,c", {}, 2), ElementsAre("a", "b"));
}

TEST(CsvDialect, SkipsBlankLinesAndComments) {
  for (const char* line : {"", "  ", ",,,", " , ,", R"("","")", "# 1,2", "  % 1"})
    EXPECT_TRUE(is_skipped(line, {})) << line;
  for (const char* line : {"1", ",1", "a,#", "-"}) EXPECT_FALSE(is_skipped(line, {})) << line;
}

TEST(CsvDialect, FindsColumnsOfNumbersBesideText) {
  const std::vector<std::string_view> lines = {"x,1,2,,note", "y,1,nan,7,", "z,,2,,"};
  EXPECT_THAT(find_number_columns(lines, {}), ElementsAre(1, 2));
  EXPECT_THAT(find_number_columns({}, {}), ElementsAre());
}

}  // namespace percuss::csv_dialect_test
