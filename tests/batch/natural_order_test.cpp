#include "batch/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace percuss::batch::natural_order_test {

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

}  // namespace percuss::batch::natural_order_test
