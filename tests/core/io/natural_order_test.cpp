#include "core/io/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace percuss::natural_order_test {

TEST(NaturalOrder, ComparesNumbersByTheirValue) {
  const std::vector<std::string> ordered{"a",        "hit",       "hit1.csv", "hit2.csv",  "hit002b.csv",
                                         "hit9.csv", "hit10.csv", "hit10a",   "run1/hit3", "run2/hit1"};
  std::vector<std::string> sorted = ordered;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_NE(sorted, ordered) << "the order of characters";
  std::sort(sorted.begin(), sorted.end(), comes_first_naturally);
  EXPECT_EQ(sorted, ordered);
}

// std::sort needs a strict order: no name before itself, and of two different names one is first.
TEST(NaturalOrder, IsStrict) {
  const std::vector<std::string> names{"", "1", "01", "001", "1a", "01a", "a1", "a01", "a1b2", "a01b02", "a"};
  for (const std::string& a : names) {
    for (const std::string& b : names) {
      EXPECT_EQ(comes_first_naturally(a, b) + comes_first_naturally(b, a), a == b ? 0 : 1) << a << " " << b;
      for (const std::string& c : names) {
        const bool chain = comes_first_naturally(a, b) && comes_first_naturally(b, c);
        EXPECT_TRUE(!chain || comes_first_naturally(a, c)) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

std::vector<std::string> ordered(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  for (const std::size_t i : intended_order(names)) out.push_back(names[i]);
  return out;
}

using Names = std::vector<std::string>;

TEST(IntendedOrder, SortsTheExpansionOfAShellPatternByNumbers) {
  EXPECT_EQ(ordered({"d/p1.csv", "d/p10.csv", "d/p11.csv", "d/p2.csv"}),
            (Names{"d/p1.csv", "d/p2.csv", "d/p10.csv", "d/p11.csv"}));
  EXPECT_EQ(ordered({"p10.csv", "p1.csv", "p20.csv", "p2.csv"}), (Names{"p1.csv", "p2.csv", "p10.csv", "p20.csv"}))
      << "the order of a locale that ignores punctuation";
  EXPECT_EQ(ordered({"v1.5/p1.csv", "v1.5/p10.csv", "v1.5/p2.csv"}),
            (Names{"v1.5/p1.csv", "v1.5/p2.csv", "v1.5/p10.csv"}));
  EXPECT_EQ(ordered({"a1", "a10", "a2", "b1", "b10", "b2"}), (Names{"a1", "a2", "a10", "b1", "b2", "b10"}));
}

TEST(IntendedOrder, KeepsEveryOtherOrder) {
  for (const Names& names :
       {Names{}, Names{"p1"}, Names{"p1", "p2", "p10"}, Names{"p10", "p2", "p1"}, Names{"p2", "p1", "p10"},
        Names{"end10", "middle2", "start1"}, Names{"p0.25.csv", "p0.5.csv", "p0.75.csv"}, Names{"p01", "p02", "p10"}})
    EXPECT_EQ(ordered(names), names);
}

TEST(TextsAndNumbers, StandInTurn) {
  EXPECT_EQ(texts_and_numbers("P07_hit2"), (NameParts{"P", "07", "_hit", "2"}));
  EXPECT_EQ(texts_and_numbers("12a"), (NameParts{"", "12", "a"}));
  EXPECT_EQ(texts_and_numbers(""), NameParts{""});
}

TEST(DifferingNumbers, AreTheNumbersInWhichNamesDiffer) {
  const auto differing = [](const std::vector<std::string>& names) {
    std::vector<NameParts> parts;
    for (const std::string& name : names) parts.push_back(texts_and_numbers(name));
    return differing_numbers(parts);
  };
  EXPECT_EQ(differing({"a1b2c3", "a1b4c3"}), std::set<std::size_t>{3});
  EXPECT_EQ(differing({"a1b2", "a1b4", "a7b2"}), (std::set<std::size_t>{1, 3}));
  EXPECT_EQ(differing({"a1", "a1"}), std::set<std::size_t>{});
  EXPECT_FALSE(differing({"a1", "b1"})) << "another text";
  EXPECT_FALSE(differing({"a1", "a1b"})) << "more parts";
}

}  // namespace percuss::natural_order_test
