#include "model/trampoline/trampoline_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/ccor_points.hpp"
#include "support/input_error.hpp"

namespace percuss::model::trampoline_fit_test {

constexpr double kDeviation = 0.004;

std::vector<MeasuredCor> exact() { return test::ccor_points(kDeviation); }

Trampoline distant_start() {
  Trampoline start = baseball_on_barrel();
  start.stiffness_exponent = 0.60;
  start.damping_exponent = 0.55;
  return start;
}

TEST(TrampolineFit, RecoversTheExponents) {
  const ExponentFit fit = fit_exponents(distant_start(), exact());
  constexpr double kSettled = 1e-7;  // the figures are exact to 1e-13, but the pair is ill-conditioned
  EXPECT_NEAR(fit.stiffness_exponent, 0.6495, kSettled);
  EXPECT_NEAR(fit.damping_exponent, 0.5202, kSettled);
  EXPECT_LT(fit.chi2, 1e-9);
  EXPECT_EQ(fit.beyond_std, 0U);
}

// At these speeds a and b change the COR almost alike. An error of 0.004 in COR leaves the exponent a undetermined,
// but determines b for a given a.
TEST(TrampolineFit, StatesTheCorrelationOfTheExponents) {
  const ExponentFit fit = fit_exponents(baseball_on_barrel(), exact());
  EXPECT_GT(fit.stiffness_exponent_std, 1);
  EXPECT_GT(fit.correlation, 0.99999);
  EXPECT_LT(fit.damping_exponent_std_given_a, 0.002);
  EXPECT_NEAR(fit.damping_exponent_std_given_a, fit.damping_exponent_std * std::sqrt(1 - std::pow(fit.correlation, 2)),
              1e-3 * fit.damping_exponent_std_given_a);  // 1 − ρ² cancels
}

// 100 measurements with normal errors: the mean of the squared deviations over the stated variance is 1 ± √(2/100).
TEST(TrampolineFit, StatesTheStandardDeviationsOfItsScatter) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 100;
  double a = 0, b = 0, chi2 = 0;
  for (int run = 0; run < kRuns; ++run) {
    auto measured = exact();
    for (auto& m : measured) m.cor_std = kDeviation / 10, m.cor += m.cor_std * normal(random);
    const ExponentFit fit = fit_exponents(baseball_on_barrel(), measured);
    a += std::pow((fit.stiffness_exponent - 0.6495) / fit.stiffness_exponent_std, 2) / kRuns;
    b += std::pow((fit.damping_exponent - 0.5202) / fit.damping_exponent_std, 2) / kRuns;
    chi2 += fit.chi2 / kRuns;
  }
  const double three_sigma = 3 * std::sqrt(2.0 / kRuns);
  EXPECT_NEAR(a, 1, three_sigma);
  EXPECT_NEAR(b, 1, three_sigma);
  EXPECT_NEAR(chi2, 3, 3 * std::sqrt(6.0 / kRuns));  // five points, two unknowns
}

TEST(TrampolineFit, RefusesSpeedsThatDoNotSeparateTheExponents) {
  auto same = exact();
  for (auto& m : same) m.speed_mps = 40;
  EXPECT_THAT(test::input_error_of([&] { fit_exponents(distant_start(), same); }),
              testing::HasSubstr("two different speeds"));
  auto alike = exact();
  alike.resize(2);
  alike[1].speed_mps = alike[0].speed_mps * 1.001;
  EXPECT_THAT(test::input_error_of([&] { fit_exponents(baseball_on_barrel(), alike); }),
              testing::HasSubstr("measured CCOR"));
}

constexpr double kA = 0.6495, kB = 0.5202;  // of the exact measurements

std::vector<MeasuredCor> with_std(std::vector<MeasuredCor> measured, double std) {
  for (auto& m : measured) m.cor_std = std;
  return measured;
}

TEST(TrampolineFit, HoldsAnExponent) {
  const ExponentFit fit_b = fit_exponents(baseball_on_barrel(), exact(), {.stiffness = true});
  EXPECT_EQ(fit_b.stiffness_exponent, kA);
  EXPECT_EQ(fit_b.stiffness_exponent_std, 0);
  EXPECT_NEAR(fit_b.damping_exponent, kB, 1e-9);
  EXPECT_EQ(fit_b.damping_exponent_std, fit_b.damping_exponent_std_given_a);
  EXPECT_TRUE(fit_b.determined);
  const ExponentFit fit_a = fit_exponents(baseball_on_barrel(), exact(), {.damping = true});
  EXPECT_EQ(fit_a.damping_exponent, kB);
  EXPECT_NEAR(fit_a.stiffness_exponent, kA, 1e-9);
  const ExponentFit none = fit_exponents(distant_start(), exact(), {.stiffness = true, .damping = true});
  EXPECT_EQ(none.stiffness_exponent, 0.60);
  EXPECT_EQ(none.free(), 0U);
  EXPECT_TRUE(none.contour.empty());
  EXPECT_GT(none.chi2, 1);  // this pair does not fit
  auto one = exact();
  one.resize(1);
  EXPECT_NEAR(fit_exponents(baseball_on_barrel(), one, {.stiffness = true}).damping_exponent, kB, 1e-9);
}

TEST(TrampolineFit, SaysThatThePairIsNotDetermined) {
  const ExponentFit fit = fit_exponents(baseball_on_barrel(), exact());
  EXPECT_FALSE(fit.determined);
  EXPECT_LT(fit.a_interval.low, kA - 0.5);
  EXPECT_GT(fit.a_interval.high, kA + 0.5);
  EXPECT_TRUE(fit_exponents(baseball_on_barrel(), with_std(exact(), 1e-4)).determined);
}

// If the model is linear within the standard deviations, the pairs with chi2 + 1 span ± one standard deviation.
TEST(TrampolineFit, HasAContourThatSpansTheStandardDeviations) {
  const ExponentFit fit = fit_exponents(baseball_on_barrel(), with_std(exact(), 2e-5));
  constexpr double kStepError = 0.03;  // eight steps over half the contour miss its extremes by up to 2 %
  EXPECT_NEAR((fit.a_interval.high - fit.a_interval.low) / (2 * fit.stiffness_exponent_std), 1, kStepError);
  EXPECT_NEAR((fit.b_interval.high - fit.b_interval.low) / (2 * fit.damping_exponent_std), 1, kStepError);
  const auto measured = with_std(exact(), 2e-5);
  const CcorMisfit misfit(baseball_on_barrel(), measured);
  for (const Exponents& e : fit.contour) EXPECT_NEAR(misfit.chi2(e) - fit.chi2, 1, 0.05) << e.transpose();
}

// The five points of a test in which the free pair runs to b = 0 with a negative a: a ball that softens.
TEST(TrampolineFit, KeepsToExponentsThatABallCanHave) {
  const std::vector<double> cor{0.5242, 0.5028, 0.5036, 0.4930, 0.4879};
  auto measured = exact();
  for (std::size_t i = 0; i < measured.size(); ++i) measured[i].cor = cor[i];
  const ExponentFit fit = fit_exponents(baseball_on_barrel(), measured);
  EXPECT_EQ(fit.stiffness_exponent, 0);
  EXPECT_TRUE(fit.at_limit);
  EXPECT_FALSE(fit.determined);
  const CcorMisfit misfit(baseball_on_barrel(), measured);
  for (double b = 0.10; b < 0.25; b += 0.01) EXPECT_GE(misfit.chi2({0, b}), fit.chi2);
}

TEST(TrampolineFit, DoubtsPointsThatNoExponentsFit) {
  auto measured = exact();
  measured[2].cor += 10 * kDeviation;
  EXPECT_LT(fit_exponents(baseball_on_barrel(), measured).chi2_p, 1e-6);
  EXPECT_GT(fit_exponents(baseball_on_barrel(), exact()).chi2_p, 0.999);
}

}  // namespace percuss::model::trampoline_fit_test
