#include "identify/fit/joint_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/budget.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::joint_projection_test {

const std::vector<Pole> kTruth{{300.3, 0.01}, {305, 0.012}, {420, 0.006}};

FrfDataset three_modes(Complex turn = 1) {
  FrfDataset set = test::empty_set(4096, 32768, 250, 500, 2);
  for (std::size_t o = 0; o < 2; ++o) {
    for (std::size_t m = 0; m < kTruth.size(); ++m)
      test::add_mode(set, o, kTruth[m], turn * (0.3 + 0.2 * static_cast<double>(m) - static_cast<double>(o)));
    for (std::size_t k = 0; k < set.lines.count; ++k) set.channels[o].frf[k] += turn * 1.7;
  }
  return set;
}

TEST(JointProjection, HasNoResidualOnExactData) {
  constexpr double kRounding = 1e-18;  // of the lines' energy
  for (const bool real : {true, false}) {
    const FrfDataset set = three_modes(real ? Complex(1) : Complex(0.6, 0.8));
    const JointProjection projection(set, kTruth);
    const JointState state = projection.evaluate({.poles = kTruth, .real = std::vector<char>(3, real ? 1 : 0)});
    double energy = 0;
    for (const FrfChannel& channel : set.channels) {
      for (const Complex& line : channel.frf) energy += std::norm(line);
    }
    EXPECT_LE(state.cost, kRounding * energy) << real;
  }
}

TEST(JointProjection, RightHandSideIsMinusHalfTheSlopeOfTheCost) {
  constexpr double kTolerance = 1e-4;  // central differences of a cost that is curved
  FrfDataset set = three_modes(Complex(0.9, 0.1));
  test::add_frf_noise(set, 0.05, 3);
  const JointProjection projection(set, kTruth);
  const JointModel model{.poles = {{300.5, 0.011}, {305.2, 0.0115}, {420.3, 0.0062}}, .real = {1, 0, 1}};
  const NormalEquations normal = projection.normal_equations(projection.evaluate(model));
  for (std::size_t i = 0; i < 6; ++i) {
    const double step = i % 2 == 0 ? 1e-4 : 1e-7;
    const auto cost_at = [&](double by) {
      JointModel moved = model;
      (i % 2 == 0 ? moved.poles[i / 2].freq_Hz : moved.poles[i / 2].damping_ratio) += by;
      return projection.evaluate(moved).cost;
    };
    const double slope = (cost_at(step) - cost_at(-step)) / (2 * step);
    const auto at = static_cast<Eigen::Index>(i);
    EXPECT_LE(std::abs(-2 * normal.right(at) - slope), kTolerance * std::abs(slope)) << i;
  }
}

// With hundreds of modes, normal_equations and evaluate take seconds each.
TEST(JointProjection, ChecksTheBudget) {
  const FrfDataset set = three_modes();
  const JointProjection projection(set, kTruth);
  const JointModel model{.poles = kTruth, .real = {1, 0, 1}};
  const JointState state = projection.evaluate(model);
  BudgetMeter spent({.time_s = 0}, "a.h5");
  const BudgetScope scope(spent);
  EXPECT_THROW(projection.normal_equations(state), BudgetSpent);
  EXPECT_THROW(projection.evaluate(model), BudgetSpent);
}

TEST(JointProjection, FindsTheNoiseOfEachFrf) {
  constexpr double kTolerance = 0.05;  // of an rms over 2000 lines, four standard deviations
  FrfDataset set = three_modes();
  test::add_frf_noise(set, 0.02, 5);
  std::vector<Complex>& second = set.channels[1].frf;
  const FrfDataset clean = three_modes();
  for (std::size_t k = 0; k < second.size(); ++k)
    second[k] = clean.channels[1].frf[k] + 5.0 * (second[k] - clean.channels[1].frf[k]);
  JointProjection projection(set, kTruth);
  const JointModel model{.poles = kTruth, .real = {1, 1, 1}};
  const JointState flat = projection.evaluate(model);
  projection.weight_by_residual(flat, projection.unweighted_residual(flat));
  EXPECT_LE(std::abs(projection.noise()(0) / 0.02 - 1), kTolerance);
  EXPECT_LE(std::abs(projection.noise()(1) / 0.10 - 1), kTolerance);
  // With these weights every row has the variance 1.
  constexpr double kVarianceTolerance = 0.12;  // of a variance from over a thousand rows, three standard deviations
  const JointState state = projection.evaluate(model);
  EXPECT_LE(std::abs(state.cost / static_cast<double>(state.parts[0].residual.size()) - 1), kVarianceTolerance);
}

}  // namespace percuss::identify::joint_projection_test
