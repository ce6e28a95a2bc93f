#include "core/io/counted_words.hpp"

#include <gtest/gtest.h>

namespace percuss::counted_words_test {

std::string numbers(std::size_t count) {
  return limited_list(count, 3, [](std::size_t i) { return std::to_string(i); });
}

TEST(CountedWords, ListTheFirstNames) {
  EXPECT_EQ(numbers(0), "");
  EXPECT_EQ(numbers(1), "0");
  EXPECT_EQ(numbers(3), "0, 1, 2");
  EXPECT_EQ(numbers(7), "0, 1, 2 and 4 more");
}

TEST(CountedWords, HaveAPlural) {
  EXPECT_STREQ(plural(0), "s");
  EXPECT_STREQ(plural(1), "");
  EXPECT_STREQ(plural(2), "s");
}

}  // namespace percuss::counted_words_test
