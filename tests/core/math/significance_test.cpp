#include "core/math/significance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::significance_test {

// The tables have four decimals.
TEST(StudentQuantile, AgreesWithTables) {
  EXPECT_NEAR(student_quantile(1.959964, 1), 12.7062, 1e-3);
  EXPECT_NEAR(student_quantile(1.959964, 2), 4.3027, 1e-3);
  EXPECT_NEAR(student_quantile(1.959964, 4), 2.7764, 1e-3);
  EXPECT_NEAR(student_quantile(2.575829, 3), 5.8409, 1e-3);
  EXPECT_NEAR(student_quantile(-1.959964, 2), -4.3027, 1e-3);
  EXPECT_GT(student_quantile(1.959964, 1.5), student_quantile(1.959964, 1.6));  // between whole numbers, too
  EXPECT_NEAR(student_quantile(1.959964, 1e6), 1.959964, 1e-4);
}

TEST(StudentFactor, WidensAStandardDeviationOfFewValues) {
  EXPECT_NEAR(student_factor(1), 12.7062 / 1.96, 1e-3);
  EXPECT_NEAR(student_factor(4), 2.7764 / 1.96, 1e-3);
  EXPECT_NEAR(student_factor(1e6), 1, 1e-4);
}

// The tolerances allow for the error of the cube-root approximation.
TEST(Chi2Deviate, IsTheNormalDeviateOfTheSameProbability) {
  EXPECT_NEAR(chi2_deviate(9.488, 4), 1.645, 0.02) << "95 %";
  EXPECT_NEAR(chi2_deviate(18.467, 4), 3.09, 0.05) << "99.9 %";
  EXPECT_NEAR(chi2_deviate(10.828, 1), 3.09, 0.06) << "99.9 %";
}

TEST(BirgeRatio, WidensStandardDeviationsThatChanceDoesNotExplain) {
  EXPECT_EQ(birge_ratio(4, 1), 1) << "two standard deviations";
  EXPECT_DOUBLE_EQ(birge_ratio(36, 1), 6);
  EXPECT_EQ(birge_ratio(14, 7), 1);
  EXPECT_DOUBLE_EQ(birge_ratio(70, 7), std::sqrt(10.0));
  EXPECT_EQ(birge_ratio(1e-9, 0), 1) << "as many unknowns as values";
}

TEST(UpperTail, IsTheProbabilityOfANormalDeviate) {
  EXPECT_NEAR(upper_tail(0), 0.5, 1e-15);
  EXPECT_NEAR(upper_tail(3.0902323062), 1e-3, 1e-7);
  EXPECT_NEAR(upper_tail(-3.0902323062), 0.999, 1e-7);
}

TEST(ChanceOfCount, IsTheTailOfTheBinomialDistribution) {
  EXPECT_NEAR(chance_of_count(1, 1, 0.2), 0.2, 1e-12);
  EXPECT_NEAR(chance_of_count(2, 2, 0.5), 0.25, 1e-12);
  EXPECT_NEAR(chance_of_count(1, 20, 1e-3), 1 - std::pow(1 - 1e-3, 20), 1e-12);
  EXPECT_NEAR(chance_of_count(2, 20, 1e-3), 190e-6, 3e-6) << "190 pairs";
  EXPECT_EQ(chance_of_count(3, 20, 0), 0);
}

}  // namespace percuss::significance_test
