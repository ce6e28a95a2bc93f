#include "metrics/study/association.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synth/random_stream.hpp"

namespace percuss::metrics::association_test {

constexpr double kRounding = 1e-12;

// Pairs of normal variables with correlation rho.
ClassPoints normal_pairs(std::uint64_t seed, std::size_t n, double rho) {
  synth::RandomStream random{17, seed};
  std::vector<double> draws(2 * n, 0);
  random.add_normal(1, draws);
  ClassPoints out;
  for (std::size_t i = 0; i < n; ++i) {
    out.x.push_back(draws[2 * i]);
    out.y.push_back(rho * draws[2 * i] + std::sqrt(1 - rho * rho) * draws[2 * i + 1]);
  }
  return out;
}

TEST(Association, IsOneForPointsOnALine) {
  const auto a = association_of({{{1, 2, 3, 4, 5}, {3, 5, 7, 9, 11}}});
  ASSERT_TRUE(a);
  EXPECT_NEAR(a->pearson.value, 1, kRounding);
  EXPECT_NEAR(a->spearman.value, 1, kRounding);
  EXPECT_NEAR(a->p, 2.0 / 120, kRounding);  // two of 5! orders
}

TEST(Association, DependsOnlyOnRanksForSpearman) {
  const auto a = association_of({{{1, 2, 3, 4, 5, 6}, {1, 8, 27, 64, 125, 1e9}}});
  EXPECT_NEAR(a->spearman.value, 1, kRounding);
  EXPECT_LT(a->pearson.value, 0.8);
}

// By hand: x 1 2 3 4 5, y 2 1 4 3 5: Σd² = 4, ρ = 1 − 6·4/(5·24) = 0.8; on ranks r is the same.
TEST(Association, MatchesAHandComputation) {
  const auto a = association_of({{{1, 2, 3, 4, 5}, {2, 1, 4, 3, 5}}});
  EXPECT_NEAR(a->spearman.value, 0.8, kRounding);
  EXPECT_NEAR(a->pearson.value, 0.8, kRounding);
  // Σd² ≤ 4 in 8 of 120 orders: the sorted one, 4 swaps of neighbours, 3 pairs of such swaps. As many have Σd² ≥ 36.
  EXPECT_NEAR(a->p, 16.0 / 120, kRounding);
  EXPECT_NEAR(a->pearson.high, std::tanh(std::atanh(0.8) + 1.959963984540054 / std::sqrt(2.0)), kRounding);
}

TEST(Association, UsesMidranksForTies) {
  // Ranks of y: 1.5 1.5 3 4. About the means, Σxy = 4.5, Σx² = 5 and Σy² = 4.5.
  const auto a = association_of({{{1, 2, 3, 4}, {7, 7, 8, 9}}});
  EXPECT_NEAR(a->spearman.value, 4.5 / std::sqrt(5 * 4.5), kRounding);
}

TEST(Association, IgnoresDifferencesBetweenClasses) {
  // y falls with x within each class, and rises from class to class.
  const ClassPoints low{{1, 2, 3, 4}, {4, 3, 2, 1}}, high{{11, 12, 13, 14}, {14, 13, 12, 11}};
  const auto a = association_of({low, high});
  EXPECT_NEAR(a->pearson.value, -1, kRounding);
  EXPECT_NEAR(a->spearman.value, -1, kRounding);
  EXPECT_EQ(a->classes, 2U);
  EXPECT_EQ(association_of({low, high, {{1}, {1}}})->points, 8U);  // a class of one point adds nothing
}

TEST(Association, NeedsPointsThatVary) {
  EXPECT_FALSE(association_of({}));
  EXPECT_FALSE(association_of({{{1, 2, 3}, {1, 2, 3}}}));
  EXPECT_FALSE(association_of({{{1, 1, 1, 1, 1}, {1, 2, 3, 4, 5}}}));
  EXPECT_FALSE(association_of({{{1, 2, 3, 4, 5}, {1, 1, 1, 1, 1}}}));
}

struct Coverage {
  double pearson = 0, spearman = 0, false_positives = 0;
};

Coverage coverage_of(double rho, std::size_t n, std::size_t classes, int runs) {
  const double rho_s = 6 / std::numbers::pi * std::asin(rho / 2);  // of a normal pair
  Coverage out;
  for (int run = 0; run < runs; ++run) {
    std::vector<ClassPoints> all;
    for (std::size_t c = 0; c < classes; ++c) {
      all.push_back(normal_pairs(static_cast<std::uint64_t>(run) * 10 + c, n, rho));
      for (double& y : all.back().y) y += 10 * static_cast<double>(c);
    }
    const auto a = association_of(all);
    out.pearson += (a->pearson.low <= rho && rho <= a->pearson.high) / static_cast<double>(runs);
    out.spearman += (a->spearman.low <= rho_s && rho_s <= a->spearman.high) / static_cast<double>(runs);
    out.false_positives += (a->p < 0.05) / static_cast<double>(runs);
  }
  return out;
}

TEST(Association, HasIntervalsOfTheStatedCoverage) {
  // 2000 runs: 0.95 ± 0.0049. Four standard deviations, plus 0.01 because Fisher's z is an approximation.
  constexpr double kAllowed = 0.03;
  for (const double rho : {0.0, 0.5, -0.8}) {
    const Coverage c = coverage_of(rho, 30, 1, 2000);
    EXPECT_NEAR(c.pearson, 0.95, kAllowed) << rho;
    EXPECT_NEAR(c.spearman, 0.95, kAllowed) << rho;
  }
  const Coverage classes = coverage_of(0.5, 15, 4, 2000);
  EXPECT_NEAR(classes.pearson, 0.95, kAllowed);
}

// The rate is at most 5 % for every size. Below 13 bats the test is exact, and the steps of its distribution keep the
// rate below 5 %.
TEST(Association, HasAtMostTheStatedFalsePositivesInSmallClasses) {
  constexpr double kAllowed = 0.05 + 0.015;  // three standard deviations in 2000 runs
  for (const auto& [bats, classes] : std::vector<std::pair<std::size_t, std::size_t>>{
           {4, 1}, {5, 1}, {6, 1}, {7, 1}, {8, 1}, {10, 1}, {13, 1}, {20, 1}, {2, 5}, {3, 3}, {4, 2}, {3, 8}})
    EXPECT_LE(coverage_of(0, bats, classes, 2000).false_positives, kAllowed) << bats << " × " << classes;
}

TEST(Association, HasIntervalsThatCoverSmallClasses) {
  constexpr double kAllowed = 0.05 + 0.022;  // three standard deviations of 0.05 in 1000 runs
  for (const auto& [bats, classes] : std::vector<std::pair<std::size_t, std::size_t>>{
           {4, 1}, {5, 1}, {6, 1}, {8, 1}, {12, 1}, {4, 2}, {3, 3}, {4, 3}}) {
    for (const double rho : {0.0, 0.6, 0.9, 0.99})
      EXPECT_GE(coverage_of(rho, bats, classes, 1000).spearman, 1 - kAllowed)
          << bats << " × " << classes << ", " << rho;
  }
}

TEST(Association, IsNotCertainOfAFewBatsInOrder) {
  const auto a = association_of({{{1, 2, 3, 4}, {1, 8, 27, 64}}});
  EXPECT_NEAR(a->p, 1.0 / 12, kRounding);
  EXPECT_EQ(a->spearman.value, 1);
  EXPECT_EQ(a->spearman.high, 1);
  EXPECT_LT(a->spearman.low, 0);  // by chance one of 24 orders is this one: more than 2.5 %
  const auto line = association_of({{{1, 2, 3, 4}, {10, 20, 30, 40}}});
  EXPECT_LT(line->pearson.low, 0);
  const auto many =
      association_of({{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, {2, 3, 5, 6, 8, 9, 11, 12, 14, 15, 17, 18}}});
  EXPECT_GT(many->spearman.low, 0.9);
  EXPECT_LT(many->spearman.low, 0.999);
}

TEST(Association, HasTheStatedFalsePositiveRate) {
  constexpr double kAllowed = 0.02;  // four standard deviations of 0.05 in 2000 runs
  EXPECT_NEAR(coverage_of(0, 12, 1, 2000).false_positives, 0.05, kAllowed);
  EXPECT_NEAR(coverage_of(0, 8, 4, 2000).false_positives, 0.05, kAllowed);
}

TEST(TrendLine, IsExactOnALineAndUnmovedByAFewBadPoints) {
  ClassPoints points;
  for (int i = 0; i < 20; ++i) {
    points.x.push_back(i);
    points.y.push_back(3 - 0.5 * i);
  }
  const auto exact = trend_line_of(points);
  EXPECT_NEAR(exact->slope, -0.5, kRounding);
  EXPECT_NEAR(exact->at, 3, kRounding);
  for (const std::size_t i : {2U, 7U, 11U, 17U}) points.y[i] = 1000.0 * static_cast<double>(i);
  const auto robust = trend_line_of(points);
  EXPECT_NEAR(robust->slope, -0.5, kRounding);
  EXPECT_NEAR(robust->at, 3, kRounding);
}

TEST(TrendLine, NeedsThreeValuesOfX) {
  EXPECT_FALSE(trend_line_of({}));
  EXPECT_FALSE(trend_line_of({{1, 2}, {1, 2}}));
  EXPECT_FALSE(trend_line_of({{1, 1, 2, 2}, {1, 2, 3, 4}}));
}

TEST(TrendLine, HasAnIntervalOfTheStatedCoverage) {
  int covered = 0;
  const int runs = 1000;
  for (int run = 0; run < runs; ++run) {
    const auto line = trend_line_of(normal_pairs(static_cast<std::uint64_t>(run) + 90000, 20, 0.6));
    covered += line->slope_low <= 0.6 && 0.6 <= line->slope_high ? 1 : 0;
  }
  constexpr double kAllowed = 0.03;  // four standard deviations of 0.95 in 1000 runs
  EXPECT_NEAR(covered / static_cast<double>(runs), 0.95, kAllowed);
}

TEST(TrendLine, HasAnIntervalThatCoversAFewPoints) {
  const auto four = trend_line_of({{1, 2, 3, 4}, {1, 3, 4, 8}});
  EXPECT_TRUE(std::isinf(four->slope_low) && four->slope_low < 0);
  EXPECT_TRUE(std::isinf(four->slope_high) && four->slope_high > 0);
  const auto five = trend_line_of({{1, 2, 3, 4, 5}, {1, 3, 4, 8, 9}});  // 1 of 120 orders on each side
  EXPECT_NEAR(five->slope_low, 1, kRounding);
  EXPECT_NEAR(five->slope_high, 4, kRounding);
  for (const std::size_t points : {5U, 6U, 8U, 12U}) {
    int covered = 0;
    const int runs = 1000;
    for (int run = 0; run < runs; ++run) {
      const auto line = trend_line_of(normal_pairs(static_cast<std::uint64_t>(run) + 70000, points, 0.6));
      covered += line->slope_low <= 0.6 && 0.6 <= line->slope_high ? 1 : 0;
    }
    EXPECT_GE(covered, 950 - 21) << points;  // three standard deviations
  }
}

TEST(Outliers, LieFarFromTheLine) {
  ClassPoints points = normal_pairs(5, 40, 0.9);
  points.y[13] += 8;
  EXPECT_THAT(outliers_of(points, *trend_line_of(points)), testing::ElementsAre(13));
  EXPECT_THAT(outliers_of({{1, 2, 3, 4, 5}, {1, 2, 3, 4, 50}}, {.slope = 1}), testing::IsEmpty());
}

TEST(HolmAdjusted, MatchesHolm) {
  EXPECT_THAT(holm_adjusted({0.01, 0.04, 0.03, 0.005}),
              testing::ElementsAre(testing::DoubleNear(0.03, kRounding), testing::DoubleNear(0.06, kRounding),
                                   testing::DoubleNear(0.06, kRounding), testing::DoubleNear(0.02, kRounding)));
  EXPECT_THAT(holm_adjusted({0.9, 0.8}), testing::ElementsAre(1, 1));
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace percuss::metrics::association_test
