#include "model/trampoline/exponent_family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/ccor_points.hpp"

namespace percuss::model::exponent_family_test {

constexpr double kA = test::kCcorStiffnessExponent, kB = test::kCcorDampingExponent;

std::vector<double> hoops(double low, double step, double high) {
  std::vector<double> out;
  for (double f = low; f <= high; f += step) out.push_back(f);
  return out;
}

double wall_cor(double a, double b, double speed_mps) {
  Trampoline model = baseball_on_barrel();
  model.stiffness_exponent = a;
  model.damping_exponent = b;
  model.ball_speed_mps = speed_mps;
  return rigid_wall_rebound(model).cor;
}

bool is_within(const std::vector<MeasuredCor>& measured, double a, double b) {
  for (const MeasuredCor& m : measured) {
    if (std::abs(wall_cor(a, b, m.speed_mps) - m.cor) > m.cor_std) return false;
  }
  return true;
}

// Checks the criterion of the source just within and just beyond each limit.
TEST(ExponentFamily, HoldsThePairsWithinEveryDeviation) {
  const auto measured = test::ccor_points(0.004);
  const ExponentFit fit = fit_exponents(baseball_on_barrel(), measured);
  const auto family = exponent_family(baseball_on_barrel(), measured, fit, hoops(400, 200, 3000));
  ASSERT_GE(family.size(), 5U);
  std::size_t with_pairs = 0;
  for (const FamilyPair& pair : family) {
    const double a = pair.exponents[0];
    if (!pair.within_std) continue;
    ++with_pairs;
    constexpr double kBeside = 1e-6;
    const auto [low, high] = *pair.within_std;
    EXPECT_TRUE(is_within(measured, a, low + kBeside)) << a;
    EXPECT_TRUE(is_within(measured, a, high - kBeside)) << a;
    EXPECT_FALSE(is_within(measured, a, low - kBeside)) << a;
    EXPECT_FALSE(is_within(measured, a, high + kBeside)) << a;
  }
  EXPECT_GE(with_pairs, 5U);
  EXPECT_LT(family.front().exponents[0], 0.2);
  EXPECT_GT(family.back().exponents[0], 1);
  EXPECT_GT(family.front().optimum.hoop_Hz, family.back().optimum.hoop_Hz + 1000);
}

TEST(ExponentFamily, IsOnePairForAHeldExponent) {
  const auto measured = test::ccor_points(0.004);
  for (const HeldExponents held : {HeldExponents{.stiffness = true}, HeldExponents{.damping = true}}) {
    const ExponentFit fit = fit_exponents(baseball_on_barrel(), measured, held);
    const auto family = exponent_family(baseball_on_barrel(), measured, fit, hoops(800, 100, 1800));
    ASSERT_EQ(family.size(), 1U);
    ASSERT_TRUE(family[0].within_std);
    EXPECT_LT(family[0].within_std->at(0), held.stiffness ? kB : kA);
    EXPECT_GT(family[0].within_std->at(1), held.stiffness ? kB : kA);
    EXPECT_NEAR(family[0].optimum.hoop_Hz, 1255.17, 0.1);
  }
}

// 50 sets of points with normal errors: the squared error of the optimum over its stated variance is 1 ± √(2/50). The
// errors are small enough for a curve that is linear in the exponents.
TEST(SweepRange, StatesTheStandardDeviationOfTheOptimum) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 50;
  const auto grid = hoops(1050, 100, 1450);
  double squares = 0, curve = 0;
  const std::size_t at = 0;
  const double true_cor = rebound(baseball_on_barrel(), grid[at]).cor;
  for (int run = 0; run < kRuns; ++run) {
    auto measured = test::ccor_points(3e-5);
    for (auto& m : measured) m.cor += m.cor_std * normal(random);
    const ExponentFit fit = fit_exponents(baseball_on_barrel(), measured);
    Trampoline fitted = baseball_on_barrel();
    fitted.stiffness_exponent = fit.stiffness_exponent;
    fitted.damping_exponent = fit.damping_exponent;
    const auto sweep = hoop_sweep(fitted, grid);
    const SweepRange range = sweep_range(fitted, fit, grid, sweep);
    EXPECT_FALSE(range.at_edge);
    const double std = (range.high.hoop_Hz - range.low.hoop_Hz) / 2;
    const double optimum = optimal_hoop_frequency(fitted, grid, sweep).hoop_Hz;
    squares += std::pow((optimum - 1255.1695630744) / std, 2) / kRuns;
    curve += std::pow((sweep[at].cor - true_cor) / ((range.cor_high[at] - range.cor_low[at]) / 2), 2) / kRuns;
  }
  const double three_sigma = 3 * std::sqrt(2.0 / kRuns);
  EXPECT_NEAR(squares, 1, three_sigma);
  EXPECT_NEAR(curve, 1, three_sigma);
}

TEST(HoopOptimum, SaysThatItIsAnEndOfTheSweep) {
  const auto peak_of = [](const std::vector<double>& grid) {
    return optimal_hoop_frequency(baseball_on_barrel(), grid, hoop_sweep(baseball_on_barrel(), grid));
  };
  EXPECT_FALSE(peak_of(hoops(1000, 100, 1500)).at_edge);
  EXPECT_TRUE(peak_of(hoops(500, 100, 1100)).at_edge);
  EXPECT_TRUE(peak_of(hoops(1400, 100, 2000)).at_edge);
}

}  // namespace percuss::model::exponent_family_test
