#include "identify/noise/force_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/units.hpp"
#include "support/modal_frfs.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::force_noise_test {

constexpr double kNoise_N = 0.02;

FrfDataset gated_hit() {
  FrfDataset set = test::empty_set(8192, 16384, 40, 2400, 1);
  test::set_gated_pulse(set, kNoise_N);
  return set;
}

std::vector<std::size_t> all_lines(const FrfDataset& set) {
  std::vector<std::size_t> lines(set.lines.count);
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  return lines;
}

TEST(GainErrors, HaveTheCovarianceOfTheNoiseInTheGate) {
  const FrfDataset set = gated_hit();
  const Eigen::MatrixXcd errors = gain_errors(set, 0, all_lines(set));
  // Independent reference: noise on every sample of the gate, transformed, over the force's spectrum.
  const frf::ForceBlock& block = set.points[0].blocks[0];
  const auto force = frf::force_spectrum(block, set.lines);
  constexpr int kTrials = 2000;
  const std::vector<Eigen::Index> lines{10, 400, 1500, 4000};
  Eigen::Matrix4cd measured = Eigen::Matrix4cd::Zero();
  // The pseudo-covariance E εεᵀ: real noise is not circular at low frequencies.
  Eigen::Matrix4cd pseudo = Eigen::Matrix4cd::Zero();
  for (int trial = 0; trial < kTrials; ++trial) {
    frf::ForceBlock noise{.offset = block.offset, .force_N = std::vector<double>(90), .ungated_N = {}};
    synth::RandomStream({7, static_cast<std::uint64_t>(trial)}).add_normal(kNoise_N, noise.force_N);
    const auto spectrum = frf::force_spectrum(noise, set.lines);
    Eigen::Vector4cd error;
    for (Eigen::Index i = 0; i < 4; ++i) {
      const auto k = static_cast<std::size_t>(lines[static_cast<std::size_t>(i)]);
      error(i) = spectrum[k] / force[k];
    }
    measured += error * error.adjoint() / kTrials;
    pseudo += error * error.transpose() / kTrials;
  }
  Eigen::MatrixXcd picked(4, errors.cols());
  for (Eigen::Index i = 0; i < 4; ++i) picked.row(i) = errors.row(lines[static_cast<std::size_t>(i)]);
  const Eigen::Matrix4cd expected = picked * picked.adjoint();
  const Eigen::Matrix4cd expected_pseudo = picked * picked.transpose();
  // The tolerance of a covariance: 2000 trials scatter it by 2.2 %. The ringing that the gate cuts off is not in the
  // trials, and adds up to 4.4 % to the expected values.
  constexpr double kTolerance = 0.12;
  for (Eigen::Index i = 0; i < 4; ++i) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      const double size = std::sqrt(std::abs(expected(i, i) * expected(j, j)));
      EXPECT_LE(std::abs(measured(i, j) - expected(i, j)), kTolerance * size) << i << ' ' << j;
      EXPECT_LE(std::abs(pseudo(i, j) - expected_pseudo(i, j)), kTolerance * size) << i << ' ' << j;
    }
  }
}

TEST(GainErrors, AgreeWithTheStandardDeviationOfOneLine) {
  const FrfDataset set = gated_hit();
  const Eigen::MatrixXcd errors = gain_errors(set, 0, all_lines(set));
  const double whole = errors.row(4000).squaredNorm();
  const double one = gain_std(set, 0, set.lines.freq_Hz(4000));
  EXPECT_LE(std::abs(whole / (2 * one * one) - 1), 1e-9);
}

TEST(GainErrors, AreEmptyWithoutNoiseOrForce) {
  FrfDataset set = gated_hit();
  set.points[0].noise_N = 0;
  EXPECT_EQ(gain_errors(set, 0, {1, 2}).size(), 0);
  set.points[0].blocks.clear();
  EXPECT_EQ(gain_std(set, 0, 500), 0);
  FrfDataset unknown = gated_hit();
  unknown.points[0].ff.clear();
  EXPECT_EQ(gain_errors(unknown, 0, {1, 2}).size(), 0);
  EXPECT_EQ(gain_std(unknown, 0, 500), 0);
}

}  // namespace percuss::identify::force_noise_test
