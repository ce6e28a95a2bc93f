#include "pipeline/warnings/hit_list.hpp"

#include <gtest/gtest.h>

namespace percuss::pipeline::hit_list_test {

TEST(HitList, NamesEightHitsAndCountsTheOthers) {
  EXPECT_EQ(hit_list({3}), "hit 4");
  EXPECT_EQ(hit_list({0, 2}), "hits 1, 3");
  EXPECT_EQ(hit_list({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), "hits 1, 2, 3, 4, 5, 6, 7, 8 and 2 more");
}

}  // namespace percuss::pipeline::hit_list_test
