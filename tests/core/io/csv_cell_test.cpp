#include "core/io/csv_cell.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/io/csv_dialect.hpp"

namespace percuss::csv_cell_test {

TEST(CsvCell, QuotesSeparatorsQuotesAndLineEnds) {
  EXPECT_EQ(csv_cell("bat 1"), "bat 1");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_cell("a\nb"), "\"a\nb\"");
}

TEST(CsvCell, PutsAnApostropheBeforeTextsThatASpreadsheetComputes) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("+A1"), "'+A1");
  EXPECT_EQ(csv_cell("-A1"), "'-A1");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("\r=1"), "\"'\r=1\"");
  EXPECT_EQ(csv_cell("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
}

TEST(CsvCell, KeepsNumbersAndInnerSigns) {
  for (const char* text : {"-1.5", "+2", "-1e-3", "a=b", "1-2", "", "'quoted'", "'"}) EXPECT_EQ(csv_cell(text), text);
}

TEST(CsvCell, KeepsFormulasWhereTheyAreAskedFor) {
  EXPECT_EQ(csv_cell("=1+1", CsvFormulas::keep), "=1+1");
  EXPECT_EQ(csv_cell("=1,1", CsvFormulas::keep), "\"=1,1\"");
}

TEST(CsvCell, GivesEveryTextBack) {
  for (const std::string text : {"=1+1", "'=1+1", "''=1", "-A", "-1.5", "'-1.5", "'", "''", "'a", "@", "+", "a", ""})
    EXPECT_EQ(text_of_csv_cell(csv_cell(text)), text);
  for (const std::string text : {R"(32" bat, old)", R"(say "hi")", R"("a")", R"("")", R"(""")", R"(="x")"})
    EXPECT_EQ(text_of_csv_cell(split_cells(csv_cell(text), {}).at(0)), text);
}

}  // namespace percuss::csv_cell_test
