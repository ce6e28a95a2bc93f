#include "core/visible_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace percuss::visible_text_test {

TEST(VisibleText, KeepsPrintableTextLineFeedsAndTabs) {
  for (const std::string text : {"", " ~", "m/s² at 90°\n\tx", "打撃 \U0001F528", "a\\b", "\uFFFD"})
    EXPECT_EQ(visible_text(text), text);
}

TEST(VisibleText, ShowsControlCharactersAsEscapes) {
  EXPECT_EQ(visible_text("\x1b[31m"), "\\u001b[31m");
  EXPECT_EQ(visible_text(std::string("a\0b\r\x7f", 5)), "a\\u0000b\\u000d\\u007f");
  EXPECT_EQ(visible_text("\u0080\u0085\u009b31m\u009f\u00a0"), "\\u0080\\u0085\\u009b31m\\u009f\u00a0");
}

TEST(VisibleText, ShowsCharactersThatReorderOrBreakLines) {
  EXPECT_EQ(visible_text("\u202a\u202b\u202c\u202d\u202e"), "\\u202a\\u202b\\u202c\\u202d\\u202e");
  EXPECT_EQ(visible_text("\u2066\u2067\u2068\u2069"), "\\u2066\\u2067\\u2068\\u2069");
  EXPECT_EQ(visible_text("\u200e\u200f\u061c"), "\\u200e\\u200f\\u061c");
  EXPECT_EQ(visible_text("\u2028\u2029"), "\\u2028\\u2029");
}

TEST(VisibleText, ShowsCharactersWithoutWidth) {
  EXPECT_EQ(visible_text("a\u200bb\u200c\u200d\u2060\ufeff\u00ad"), "a\\u200bb\\u200c\\u200d\\u2060\\ufeff\\u00ad");
  EXPECT_EQ(visible_text("\U000E0041"), "\\udb40\\udc41");  // a tag, as JSON writes it
}

TEST(VisibleText, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(visible_text("a\xff\x9b"), "a\\xff\\x9b");
  EXPECT_EQ(visible_text("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(visible_text("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(visible_text("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(visible_text("\xe2\x80"), "\\xe2\\x80");  // incomplete
}

TEST(VisibleText, ChangesNothingOfItsOwnOutput) {
  const std::string shown = visible_text("\u202e\x9b\x1b\U000E0041");
  EXPECT_EQ(visible_text(shown), shown);
}

TEST(VisibleText, KeepsTheMeaningOfJson) {
  const nlohmann::json document{{"name\u202e", "\\\u2028\x7f\U000E0041 90°\n"}};
  const std::string text = document.dump(), shown = visible_text(text);
  EXPECT_NE(shown, text);
  EXPECT_EQ(nlohmann::json::parse(shown), document);
}

}  // namespace percuss::visible_text_test
