#include "report/html/title_block.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::report::title_block_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(TitleBlock, IsTheFilesNameWhereNothingIsStated) {
  EXPECT_EQ(page_header("bat.h5", "25.6 kHz", {}),
            "<header>\n<h1>bat.h5</h1>\n<p class=\"conditions\">25.6 kHz</p>\n</header>\n");
}

TEST(TitleBlock, ShowsEachStatementAsARow) {
  const std::string html =
      page_header("bat.h5", "", {.title = "Bat 7", .customer = "Club", .facts = {{"Date", "2026"}}});
  EXPECT_THAT(html, AllOf(HasSubstr("<h1>Bat 7</h1>"), HasSubstr("<dt>Customer</dt><dd>Club</dd>"),
                          HasSubstr("<dt>Date</dt><dd>2026</dd>"), HasSubstr("<dt>Record</dt><dd>bat.h5</dd>"),
                          Not(HasSubstr("Operator"))));
}

TEST(TitleBlock, EscapesForeignText) {
  const std::string attack = "<script>alert(1)</script>\"'&";
  const std::string html = page_header(attack, attack,
                                       {.title = attack,
                                        .customer = attack,
                                        .operator_name = attack,
                                        .specimen = attack,
                                        .note = attack,
                                        .logo = "x\" onerror=\"alert(1)",
                                        .facts = {{attack, attack}}});
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("\" onerror")));
}

TEST(TitleBlock, KeepsLinesAndParagraphsOfANote) {
  EXPECT_THAT(page_header("a", "", {.note = "one\r\ntwo\n\n \nthree"}), HasSubstr("<p>one<br>two</p>\n<p>three</p>"));
}

}  // namespace percuss::report::title_block_test
