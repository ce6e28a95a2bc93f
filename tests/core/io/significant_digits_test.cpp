#include "core/io/significant_digits.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percuss::significant_digits_test {

TEST(Significant, ShowsTheGivenDigitsForAnySize) {
  EXPECT_EQ(significant(12, 3), "12.0");
  EXPECT_EQ(significant(0.04321, 3), "0.0432");
  EXPECT_EQ(significant(-0.04321, 2), "-0.043");
  EXPECT_EQ(significant(1520.4, 3), "1520");
  EXPECT_EQ(significant(1.2e-7, 3), "1.20e-07");
}

TEST(Significant, CountsDigitsOfTheRoundedNumber) {
  EXPECT_EQ(significant(9.999, 3), "10.0");
  EXPECT_EQ(significant(0.09999, 3), "0.100");
  EXPECT_EQ(significant(99.96, 3), "100");
}

TEST(Significant, NeverRoundsToZero) {
  for (double value = 1e-300; value < 1; value *= 7) EXPECT_NE(std::stod(significant(value, 1)), 0) << value;
}

TEST(Significant, ShowsZeroAndNonFiniteNumbers) {
  EXPECT_EQ(significant(0, 3), "0");
  EXPECT_EQ(significant(std::numeric_limits<double>::infinity(), 3), "inf");
}

}  // namespace percuss::significant_digits_test
