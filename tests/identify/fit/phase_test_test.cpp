#include "identify/fit/phase_test.hpp"

#include <gtest/gtest.h>

#include "core/math/linear_algebra.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::phase_test_test {

const Pole kPole{300.3, 0.01};

// Two channels of one mode with these phases, fitted with real residues.
double statistic(double first_rad, double second_rad, std::uint64_t seed) {
  FrfDataset set = test::empty_set(4096, 32768, 250, 350, 2);
  test::add_mode(set, 0, kPole, std::polar(0.5, first_rad));
  test::add_mode(set, 1, kPole, std::polar(0.4, second_rad));
  test::add_frf_noise(set, 0.1, seed);
  JointProjection projection(set, {kPole});
  const JointState complex_state = projection.evaluate({.poles = {kPole}, .real = {0}});
  projection.weight_by_residual(complex_state, projection.unweighted_residual(complex_state));
  JointState state = projection.evaluate({.poles = {kPole}, .real = {1}});
  Eigen::MatrixXd covariance;
  for (int step = 0; step < 4; ++step) {
    const NormalEquations normal = projection.normal_equations(state);
    covariance = inverse_gram(normal.matrix);
    const Eigen::VectorXd move = covariance * normal.right;
    const Pole& pole = state.model.poles[0];
    state = projection.evaluate({.poles = {{pole.freq_Hz + move(0), pole.damping_ratio + move(1)}}, .real = {1}});
  }
  return phase_test_statistic(projection, state, 0, covariance);
}

TEST(PhaseTest, AcceptsRealResidues) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) EXPECT_LE(statistic(0, 0, seed), 1) << seed;
}

TEST(PhaseTest, RejectsACommonPhaseAndDifferentPhases) {
  EXPECT_GE(statistic(0.2, 0.2, 1), 1);
  EXPECT_GE(statistic(0.2, -0.2, 1), 1);
}

}  // namespace percuss::identify::phase_test_test
