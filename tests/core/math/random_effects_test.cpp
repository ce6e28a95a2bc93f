#include "core/math/random_effects.hpp"

#include <gtest/gtest.h>

namespace percuss::random_effects_test {

constexpr double kRounding = 1e-14;

// By hand: weights 1, mean 2, χ² 2 with one degree of freedom, variance (2 − 1)/(2 − 2/2) = 1, then weights ½.
TEST(RandomEffects, MatchAHandComputation) {
  const RandomEffects out = random_effects({1, 3}, {1, 1}, 0);
  EXPECT_NEAR(out.mean, 2, kRounding);
  EXPECT_NEAR(out.chi2, 2, kRounding);
  EXPECT_NEAR(out.own_weights, 2, kRounding);
  EXPECT_NEAR(out.variance, 1, kRounding);
  EXPECT_NEAR(out.weights, 1, kRounding);
}

TEST(RandomEffects, AreAWeightedMeanWhereValuesAgree) {
  const RandomEffects out = random_effects({1, 1.1}, {1, 0.5}, 0);
  EXPECT_EQ(out.variance, 0);
  EXPECT_NEAR(out.mean, (1 + 4 * 1.1) / 5, kRounding);
  EXPECT_NEAR(out.weights, 5, kRounding);
}

// Where the noise of each value is negligible, its variance is the variance between the values times its factor: the
// weights are in proportion to 1/factor.
TEST(RandomEffects, WeightByTheFactorsOfTheVariance) {
  const RandomEffects out = random_effects({1, 2, 7}, {1e-6, 1e-6, 1e-6}, 0, {1, 1, 4});
  EXPECT_NEAR(out.mean, (1 + 2 + 7 / 4.0) / 2.25, 1e-9);
}

// In doubles, 1e9 + 1/3 has an error of 4e-8. With a value as the origin, the mean has no further error.
TEST(RandomEffects, RoundRelativeToTheOrigin) {
  std::vector<double> value(101, 1e9 + 1.0 / 3), std(101, 0.1);
  EXPECT_EQ(random_effects(value, std, value.front()).mean, value.front());
}

TEST(RandomEffects, OfOneValueAreTheValue) {
  const RandomEffects out = random_effects({3}, {0.5}, 3);
  EXPECT_EQ(out.mean, 3);
  EXPECT_EQ(out.variance, 0);
  EXPECT_NEAR(out.weights, 4, kRounding);
}

}  // namespace percuss::random_effects_test
