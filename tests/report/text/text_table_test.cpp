#include "report/text/text_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace percuss::report::text_table_test {

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, text_width(line));
  return widest;
}

TEST(TextWidth, CountsCharactersNotBytes) {
  EXPECT_EQ(text_width(""), 0U);
  EXPECT_EQ(text_width("m/s²"), 4U);
  EXPECT_EQ(text_width("± °–…"), 5U);
}

TEST(Wrapped, BreaksAtSpacesAndIndentsLaterLines) {
  EXPECT_EQ(wrapped("one two three", 7, 2), "one\n  two\n  three");
  EXPECT_EQ(wrapped("one two three", 80, 2), "one two three");
  EXPECT_EQ(wrapped("  one   two ", 80, 0), "one two");
  EXPECT_EQ(wrapped("", 10, 4), "");
}

TEST(Wrapped, LeavesAWordThatIsTooLongWhole) {
  EXPECT_EQ(wrapped("a incomprehensible b", 5, 0), "a\nincomprehensible\nb");
}

TEST(Wrapped, KeepsANumberAndItsUnitOnOneLine) {
  EXPECT_EQ(wrapped("after 11.99 ms, 35.5 % of it", 14, 2), "after\n  11.99 ms,\n  35.5 % of it");
  EXPECT_EQ(wrapped("at (12.0 Hz) it", 9, 0), "at\n(12.0 Hz)\nit");
  EXPECT_EQ(wrapped("is 3.2 ± 0.1 mm long", 6, 0), "is\n3.2 ± 0.1 mm\nlong");
}

TEST(Wrapped, KeepsEveryWordInOrder) {
  const std::string text = "the damping is fitted with the missing decay ± allowed for";
  for (std::size_t width = 1; width < 70; ++width) {
    std::istringstream broken(wrapped(text, width, 3)), whole(text);
    std::string a, b;
    while (whole >> b) {
      ASSERT_TRUE(broken >> a);
      EXPECT_EQ(a, b);
    }
    EXPECT_FALSE(broken >> a);
  }
}

TEST(TextTable, AlignsItsColumns) {
  TextTable table({{"n", TextTable::Align::right}, {"name"}, {"note"}});
  table.add({"1", "µ", "first"});
  table.add({"10", "abc", ""});
  EXPECT_EQ(table.text(80), " n  name  note\n 1  µ     first\n10  abc\n");
}

TEST(TextTable, MarksExcludedRowsInHtml) {
  TextTable table({{"hit", TextTable::Align::right}, {"verdict"}});
  table.add({"0", "ok"});
  table.add({"1", "rejected"}, false);
  const std::string html = table.html();
  EXPECT_NE(html.find("<tr><td class=\"right\">0</td>"), std::string::npos) << html;
  EXPECT_NE(html.find("<tr class=\"excluded\"><td class=\"right\">1</td>"), std::string::npos) << html;
}

TEST(TextTable, WrapsItsLastColumnUnderItself) {
  TextTable table({{"hit", TextTable::Align::right}, {"verdict"}});
  table.add({"0", "rejected: second hit after 11.2 ms, 31 % of the first"});
  EXPECT_EQ(table.text(34), "hit  verdict\n  0  rejected: second hit after\n     11.2 ms, 31 % of the first\n");
}

TEST(TextTable, ObeysTheWidthWhereWordsAllow) {
  TextTable table({{"hit", TextTable::Align::right}, {"time"}, {"verdict"}});
  std::string long_note;
  for (int i = 0; i < 60; ++i) long_note += "ein Wort über ";
  table.add({"12", "1.234 s", long_note});
  for (const std::size_t width : {40U, 60U, 80U, 120U}) {
    EXPECT_LE(widest_line(table.text(width)), width);
    EXPECT_GE(widest_line(table.text(width)), width - 5);  // and uses it: no word is longer than four characters
  }
}

TEST(TextTable, GoesOnBelowWhereItIsWiderThanTheTerminal) {
  TextTable table({{"mode", TextTable::Align::right}, {"first"}, {"second"}, {"third"}, {""}});
  table.add({"1", "100 Hz", "101 Hz", "102 Hz", ""});
  const std::string whole = table.text(12);
  table.split_after(1);
  EXPECT_EQ(table.text(80), whole);
  EXPECT_EQ(table.text(20), "mode  first   second\n   1  100 Hz  101 Hz\n\nmode  third\n   1  102 Hz\n");
  // A part has one column besides the repeated ones, however narrow the terminal.
  EXPECT_EQ(table.text(12), "mode  first\n   1  100 Hz\n\nmode  second\n   1  101 Hz\n\nmode  third\n   1  102 Hz\n");
}

}  // namespace percuss::report::text_table_test
