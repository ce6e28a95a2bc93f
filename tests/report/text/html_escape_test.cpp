#include "report/text/html_escape.hpp"

#include <gtest/gtest.h>

namespace percuss::report::html_escape_test {

TEST(HtmlText, EscapesMarkup) {
  EXPECT_EQ(html_escape("a<b>&\"'\n"), "a&lt;b&gt;&amp;&quot;&#39; ");
  EXPECT_EQ(html_escape("90° \xF0\x9F\x8F\x8F"), "90° \xF0\x9F\x8F\x8F");
  EXPECT_EQ(html_escape("\xFF\xC0\xAFx\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFDx\uFFFD\uFFFD\uFFFD");
}

}  // namespace percuss::report::html_escape_test
