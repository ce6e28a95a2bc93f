#include "core/math/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace percuss::statistics_test {

std::vector<double> gaussian(std::size_t count, double deviation) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal(0, deviation);
  std::vector<double> x(count);
  for (double& value : x) value = normal(generator);
  return x;
}

TEST(Median, IsTheMiddleValueOrTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median({5, 1, 3}), 3);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({2, 2, 2, 9}), 2);
  EXPECT_EQ(median({}), 0);
}

TEST(Median, DoesNotDependOnTheOrder) {
  std::vector<double> x = {-3, 8, 0, 1e30, -1e30, 4};
  std::sort(x.begin(), x.end());
  do {
    ASSERT_EQ(median(x), 2);
  } while (std::next_permutation(x.begin(), x.end()));
}

TEST(Median, OfAnyNumberOfValuesIsThatOfTheSortedOnes) {
  for (std::size_t count = 1; count < 40; ++count) {
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i) x[i] = static_cast<double>(i * 7 % 13) - 0.3 * static_cast<double>(i % 3);
    std::vector<double> sorted = x;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(median(x), 0.5 * (sorted[count / 2] + sorted[(count - 1) / 2])) << count;
  }
}

TEST(RobustStd, IsTheScaledMedianDeviation) {
  constexpr double kTolerance = 1e-15;  // one rounding
  EXPECT_LE(std::abs(robust_std({1, 2, 3, 4, 100}) - 1.4826022185056018), kTolerance);
  EXPECT_EQ(robust_std({5, 5, 5, 9}), 0);
  EXPECT_EQ(robust_std({7}), 0);
  EXPECT_EQ(robust_std({}), 0);
}

TEST(RobustStd, IsTheStandardDeviationOfGaussianNoise) {
  const auto x = gaussian(100000, 0.02);
  constexpr double kFiveDeviations = 5 * 1.167 / 316.2;  // of robust_std of 1e5 values: 1.167 σ/√n
  EXPECT_LE(std::abs(robust_std(x) / 0.02 - 1), kFiveDeviations);
}

TEST(RobustStd, IsNotChangedByRarePulses) {
  auto x = gaussian(10000, 1);
  const double quiet = robust_std(x);
  for (std::size_t i = 0; i < 100; ++i) x[i] = 1e12;
  constexpr double kShift = 0.02;  // 1 % of outliers raise the median deviation by 0.8 % of σ, robust_std by 1.2 %
  EXPECT_LE(std::abs(robust_std(x) - quiet), kShift * quiet);
}

TEST(RobustStd, ScalesWithTheUnitAndIgnoresTheOffset) {
  const std::vector<double> x = {0.5, 1.25, -3, 2, 8, -0.75};
  for (const int power : {-100, 100}) {
    auto scaled = x;
    for (double& value : scaled) value = -std::ldexp(value, power);
    EXPECT_EQ(robust_std(scaled), std::ldexp(robust_std(x), power));
  }
  auto shifted = x;
  for (double& value : shifted) value += 1024;  // exact in binary
  EXPECT_EQ(robust_std(shifted), robust_std(x));
}

TEST(Rms, IsTheRootOfTheMeanSquare) {
  EXPECT_EQ(rms(std::vector<double>{3, -4, 0, 0}), 2.5);
  EXPECT_EQ(rms(std::vector<double>{-6}), 6);
  EXPECT_EQ(rms({}), 0);
}

TEST(ExtremesOf, AreFoundAtAnyPlace) {
  for (std::size_t size = 1; size < 30; ++size) {
    for (std::size_t at = 0; at < size; ++at) {
      std::vector<double> values(size, 2.0);
      values[at] = -3;
      EXPECT_EQ(extremes_of(values).low, -3) << size << ' ' << at;
      values[at] = 7;
      EXPECT_EQ(extremes_of(values).high, 7) << size << ' ' << at;
    }
  }
}

TEST(BlockExtremes, AreTheExtremesOfEachBlockAndTogetherOfAllValues) {
  const std::vector<double> values{1, 5, -2, 0, 3};
  const auto blocks = block_extremes(values, 2);
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[0].high, 5);
  EXPECT_EQ(blocks[1].low, -2);
  EXPECT_EQ(blocks[2].low, 3);
  EXPECT_EQ(extremes_of(blocks).low, -2);
  EXPECT_EQ(extremes_of(blocks).high, 5);
  EXPECT_TRUE(block_extremes({}, 2).empty());
}

}  // namespace percuss::statistics_test
