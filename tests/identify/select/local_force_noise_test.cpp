#include "identify/select/local_force_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::local_force_noise_test {

constexpr double kNoise_N = 1e-3;  // of a pulse of 1 N
const Pole kPole{500, 0.05};

// The force of a hit, and a mode in two FRFs.
FrfDataset noisy_force() {
  FrfDataset set = test::empty_set(8192, 8192, 60, 2400, 2);
  test::set_gated_pulse(set, kNoise_N);
  test::add_mode(set, 0, kPole, 1);
  test::add_mode(set, 1, kPole, -0.4);
  return set;
}

FrfDataset with_a_gain(FrfDataset set, std::uint64_t seed) {
  test::add_random_gain(set, seed);
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
