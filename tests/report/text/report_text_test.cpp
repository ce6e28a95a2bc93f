#include "report/text/report_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace percuss::report::report_text_test {

TEST(ReportText, PrintsTheSameOnTerminalAndPage) {
  ReportText text(std::string("first line\n\n  second <line>\n"));
  TextTable table({{"n", TextTable::Align::right}, {"name"}});
  table.add({"1", "a&b"});
  text += table;
  text.say("a sentence that is wrapped");
  text.warn("beware");
  text.warn("beware again");
  EXPECT_EQ(
      text.text(20),
      "first line\n\n  second <line>\nn  name\n1  a&b\na sentence that is\n  wrapped\n! beware\n! beware again\n");
  EXPECT_EQ(text.html(),
            "<p class=\"verdict\">first line</p>\n<p>second &lt;line&gt;</p>\n"
            "<table>\n<thead><tr><th class=\"right\">n</th><th>name</th></tr>\n</thead>\n"
            "<tbody>\n<tr><td class=\"right\">1</td><td>a&amp;b</td></tr>\n</tbody>\n</table>\n"
            "<p>a sentence that is wrapped</p>\n<ul class=\"warnings\" aria-label=\"Warnings\">\n<li>beware</li>\n"
            "<li>beware again</li>\n</ul>\n");
}

// A remark below a table is no verdict.
TEST(ReportText, HasNoVerdictBelowATable) {
  TextTable table({{"n"}});
  table.add({"1"});
  ReportText text;
  text += table;
  text.say("a remark");
  EXPECT_THAT(text.html(), testing::EndsWith("</table>\n<p>a remark</p>\n"));
}

// A table of many columns fits into the width of the page with smaller letters.
TEST(ReportText, MarksWideTables) {
  const auto table_of = [](std::size_t columns) {
    TextTable table(std::vector<TextTable::Column>(columns, {"n"}));
    return table.html();
  };
  EXPECT_THAT(table_of(9), testing::StartsWith("<table>"));
  EXPECT_THAT(table_of(11), testing::StartsWith("<table class=\"wide\">"));
}

}  // namespace percuss::report::report_text_test
