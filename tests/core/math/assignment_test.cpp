#include "core/math/assignment.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace percuss::assignment_test {

TEST(AssignRows, TakesTheLeastTotalAndNotTheNearestFirst) {
  Eigen::MatrixXd cost(2, 2);
  cost << 1, 2,  //
      1.1, 9;
  const auto partner = assign_rows(cost, 100);
  EXPECT_EQ(partner[0], 1U);
  EXPECT_EQ(partner[1], 0U);
}

TEST(AssignRows, LeavesARowWithoutPartnerForTheLeastTotal) {
  Eigen::MatrixXd cost(3, 2);
  cost << 0.1, 5,  //
      0.2, 5,      //
      7, 0.3;
  const auto partner = assign_rows(cost, 1);
  EXPECT_EQ(partner[0], 0U);
  EXPECT_FALSE(partner[1]);
  EXPECT_EQ(partner[2], 1U);
}

TEST(AssignRows, TakesNoColumns) {
  EXPECT_EQ(assign_rows(Eigen::MatrixXd(2, 0), 1).size(), 2U);
  EXPECT_TRUE(assign_rows(Eigen::MatrixXd(0, 3), 1).empty());
}

}  // namespace percuss::assignment_test
