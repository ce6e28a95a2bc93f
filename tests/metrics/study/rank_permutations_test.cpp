#include "metrics/study/rank_permutations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percuss::metrics::rank_permutations_test {

constexpr double kRounding = 1e-12;

RankedClass in_order(int bats) {
  RankedClass out;
  for (int i = 0; i < bats; ++i) out.x.push_back(2 * i + 1 - bats);
  out.y = out.x;
  return out;
}

double product_of(const std::vector<RankedClass>& classes) {
  double sum = 0;
  for (const RankedClass& one : classes) sum += one.product();
  return sum;
}

// By trying all permutations of y in each class.
struct Enumeration {
  explicit Enumeration(std::vector<RankedClass> all)
      : classes(std::move(all)), observed(std::abs(product_of(classes))) {
    for (RankedClass& one : classes) std::sort(one.y.begin(), one.y.end());
    permute(0, 0);
  }
  void permute(std::size_t at, double product) {
    if (at == classes.size()) {
      ++orders;
      extreme += std::abs(product) >= observed - 1e-10 ? 1 : 0;
      return;
    }
    std::vector<std::size_t> order(classes[at].y.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      RankedClass one{.x = classes[at].x, .y = {}};
      for (const std::size_t i : order) one.y.push_back(classes[at].y[i]);
      permute(at + 1, product + one.product());
    } while (std::next_permutation(order.begin(), order.end()));
  }
  double p() const { return extreme / orders; }
  std::vector<RankedClass> classes;
  double observed, orders = 0, extreme = 0;
};

TEST(RankPermutations, CountTheOrdersOfFourBats) {
  EXPECT_NEAR(permutation_p({in_order(4)}), 1.0 / 12, kRounding);
  RankedClass reversed = in_order(4);
  std::reverse(reversed.y.begin(), reversed.y.end());
  EXPECT_NEAR(permutation_p({reversed}), 1.0 / 12, kRounding);
  EXPECT_NEAR(permutation_p({in_order(5)}), 1.0 / 60, kRounding);
}

// Counted in exact integers by another program (recursion over the subsets of the ranks): the two-sided probability of
// Σd² at least as far from its mean.
TEST(RankPermutations, AgreeWithAnotherCount) {
  RankedClass ten = in_order(10);
  ten.y = {-9, 1, -7, -5, -1, 3, -3, 9, 5, 7};  // Σd² = 34
  EXPECT_NEAR(permutation_p({ten}), 0.008778108465608466, kRounding);
  ten.y = {-9, -7, -5, -3, 7, 5, 3, 1, -1, 9};  // Σd² = 40
  EXPECT_NEAR(permutation_p({ten}), 0.014929453262786597, kRounding);
}

TEST(RankPermutations, EqualAnEnumerationWithTies) {
  for (const RankedClass& one : {RankedClass{{-5, -3, -1, 1, 3, 5}, {-4, -4, -1, 3, 1, 5}},
                                 RankedClass{{-5, -2, -2, 1, 3, 5}, {-4, -4, 2, 2, 2, 2}},
                                 RankedClass{{-3, -3, -3, 3, 3, 3}, {-5, -3, 1, -1, 5, 3}}})
    EXPECT_NEAR(permutation_p({one}), Enumeration({one}).p(), kRounding);
}

TEST(RankPermutations, EqualAnEnumerationOfClasses) {
  const RankedClass four{{-3, -1, 1, 3}, {-3, 1, -1, 3}}, other{{-3, -1, 1, 3}, {-1, -3, 3, 1}};
  EXPECT_NEAR(permutation_p({four, other}), Enumeration({four, other}).p(), kRounding);
  const RankedClass five{{-4, -2, 0, 2, 4}, {-4, 0, -2, 4, 2}}, three{{-2, 0, 2}, {-2, 0, 2}};
  const double exact = Enumeration({four, five, three}).p(), p = permutation_p({four, five, three});
  EXPECT_GE(p,
            exact - kRounding);  // classes of different sizes are convolved on a grid, and rounding to it only raises p
  EXPECT_LT(p, 1.05 * exact);
}

// The smallest class that is approximated, compared with the exact count of the other program.
TEST(RankPermutations, ApproximateLargeClasses) {
  RankedClass bats = in_order(13);
  constexpr double kApproximation = 0.06;                      // of p: the distribution has steps
  bats.y = {-2, -12, 8, -10, -6, -8, 2, -4, 12, 0, 6, 4, 10};  // Σd² = 150
  EXPECT_NEAR(permutation_p({bats}) / 0.038062797863145086, 1, kApproximation);
  bats.y = {-12, -8, -6, 4, 6, -4, -2, -10, 2, 0, 8, 10, 12};  // Σd² = 100
  EXPECT_NEAR(permutation_p({bats}) / 0.006661934066447955, 1, kApproximation);
  bats.y = {-10, -4, -12, -8, 2, -6, 0, -2, 4, 6, 12, 10, 8};  // Σd² = 40
  const double ratio = permutation_p({bats}) / 0.00011213580658025103;
  EXPECT_GT(ratio, 1);  // p is too large in the far tail, so it shows no false relation
  EXPECT_LT(ratio, 2.1);
}

TEST(RankPermutations, AreNeverBelowOneOrder) {
  EXPECT_GE(permutation_p({in_order(13)}), std::exp(-std::lgamma(14.0)));
  EXPECT_LT(permutation_p({in_order(13)}), 1e-5);
  EXPECT_LT(permutation_p({in_order(40)}), 1e-15);
  EXPECT_NEAR(permutation_p({in_order(12), in_order(12), in_order(12)}) / (2 * std::exp(-3 * std::lgamma(13.0))), 1,
              1e-9);
}

}  // namespace percuss::metrics::rank_permutations_test
