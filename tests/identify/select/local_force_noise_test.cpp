#include "identify/select/local_force_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/noise/force_noise.hpp"
#include "support/modal_frfs.hpp"
#include "synth/random_stream.hpp"

namespace percuss::identify::local_force_noise_test {

constexpr double kNoise_N = 1e-3;  // of a pulse of 1 N
const Pole kPole{500, 0.05};

// A pulse of 9 samples in a gate of 90, and a mode in two FRFs.
FrfDataset noisy_force() {
  FrfDataset set = test::empty_set(8192, 8192, 60, 2400, 2);
  frf::ForceBlock block{.offset = 100, .force_N = std::vector<double>(90), .ungated_N = {}};
  for (std::size_t n = 0; n < 9; ++n) block.force_N[40 + n] = std::sin(kTwoPi * (static_cast<double>(n) + 0.5) / 18);
  const frf::Spectrum spectrum = frf::shared(frf::force_spectrum(block, set.lines));
  set.points[0] = point_force({block}, {spectrum}, set.lines, kNoise_N);
  test::add_mode(set, 0, kPole, 1);
  test::add_mode(set, 1, kPole, -0.4);
  return set;
}

// The same set with a random gain from the force's errors.
FrfDataset with_a_gain(FrfDataset set, std::uint64_t seed) {
  std::vector<std::size_t> lines(set.lines.count);
  for (std::size_t k = 0; k < lines.size(); ++k) lines[k] = k;
  const Eigen::MatrixXcd errors = gain_errors(set, 0, lines);
  std::vector<double> draw(static_cast<std::size_t>(errors.cols()));
  synth::RandomStream({seed, 1}).add_normal(1, draw);
  const Eigen::VectorXcd gain = errors * Eigen::Map<const Eigen::VectorXd>(draw.data(), errors.cols());
  for (FrfChannel& channel : set.channels) {
    for (std::size_t k = 0; k < lines.size(); ++k) channel.frf[k] *= 1.0 + gain(static_cast<Eigen::Index>(k));
  }
  return set;
}

TEST(LocalForceNoise, EqualsTheScatterOfAModeWithNoiseFreeResponses) {
  constexpr int kTrials = 30;
  const FrfDataset set = noisy_force();
  double freq = 0, damping = 0;  // mean squares of errors over standard deviations
  double largest_before = 0;     // largest ratio of the standard deviations before and after add_force_noise
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrfDataset measured = with_a_gain(set, static_cast<std::uint64_t>(trial));
    auto modes = fit_sequentially(measured);
    ASSERT_EQ(modes.size(), 1U);
    const double before_Hz = modes[0].mode.freq_std_Hz;
    add_force_noise(measured, modes);
    const Mode& mode = modes[0].mode;
    largest_before = std::max(largest_before, before_Hz / mode.freq_std_Hz);
    freq += std::pow((mode.pole.freq_Hz - kPole.freq_Hz) / mode.freq_std_Hz, 2) / kTrials;
    damping += std::pow((mode.pole.damping_ratio - kPole.damping_ratio) / mode.damping_std, 2) / kTrials;
  }
  // A mean square over 30 trials is known to 26 %. The part of the gain error that the residual shows is counted twice,
  // so the mean square may be below 1.
  EXPECT_LE(freq, 1.6);
  EXPECT_GE(freq, 0.4);
  EXPECT_LE(damping, 1.6);
  EXPECT_GE(damping, 0.4);
  EXPECT_LE(largest_before, 0.9) << "the residual alone does not show the force's noise";
}

TEST(LocalForceNoise, ExcludesModesOfAJointFit) {
  const FrfDataset measured = with_a_gain(noisy_force(), 3);
  auto modes = fit_sequentially(measured);
  ASSERT_EQ(modes.size(), 1U);
  modes[0].joint = true;
  const double before_Hz = modes[0].mode.freq_std_Hz;
  add_force_noise(measured, modes);
  EXPECT_EQ(modes[0].mode.freq_std_Hz, before_Hz);
}

}  // namespace percuss::identify::local_force_noise_test
