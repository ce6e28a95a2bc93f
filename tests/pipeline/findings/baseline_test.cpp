#include "pipeline/findings/baseline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "support/force_row.hpp"

namespace percuss::pipeline::baseline_test {

RestLevels levels_after(std::initializer_list<double> after) {
  RestLevels levels{.before = 0.0, .quiet = 100, .first = 100, .window = 100};
  std::copy(after.begin(), after.end(), levels.after.begin());
  return levels;
}

TEST(BaselineChange, IsAStepThatDecays) {
  // A unit step with the time constant of one window: the means of the windows, (1 - 1/e) e^-w.
  const double e = std::exp(-1.0);
  const auto change =
      find_baseline_change(levels_after({1 - e, (1 - e) * e, (1 - e) * e * e, (1 - e) * e * e * e}), 1600, 10, 1000);
  ASSERT_TRUE(change && change->step);
  EXPECT_NEAR(change->size, 1, 1e-9);
  EXPECT_NEAR(change->decay_per_s, 10, 1e-7);
}

TEST(BaselineChange, IsNoneWhereTheShiftsCancel) {
  // Both sums of shifts are exactly zero, so that their ratio is not a number.
  EXPECT_FALSE(find_baseline_change(levels_after({1, 0.5, -1.5, 1}), 1600, 10, 1000));
}

// The mean of the 100 samples before the hit is uncertain by a tenth of their standard deviation.
TEST(BaselineChange, ExceedsTheNoiseOfTheMeanBefore) {
  RestLevels decaying = levels_after({1, 0.5, 0.25, 0.125});
  decaying.noise = 1.9;
  EXPECT_TRUE(find_baseline_change(decaying, 1600, 10, 1000)) << "5.3 standard deviations of the mean";
  decaying.noise = 2.1;
  EXPECT_FALSE(find_baseline_change(decaying, 1600, 10, 1000)) << "4.8 standard deviations of the mean";
}

/// Sine of one period in 512 samples, with this phase, for 16 periods.
std::vector<double> hum(double amplitude, double phase) {
  std::vector<double> x(16 * 512);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = amplitude * std::sin(2 * std::numbers::pi * static_cast<double>(n) / 512 + phase);
  test::add_noise(x, 0.01, 1);
  return x;
}

// The mean of the samples before a hit is not zero over a half or a quarter of a period.
TEST(BaselineChange, IsNotTheMeanOfHumBeforeTheHit) {
  for (const std::size_t quiet : {128U, 256U}) {
    for (int k = 0; k < 16; ++k) {
      const std::vector<double> x = hum(3, 2 * std::numbers::pi * k / 16);
      EXPECT_FALSE(exceeds_motion_before({.size = 3}, x, quiet)) << quiet << " " << k;
      EXPECT_TRUE(exceeds_motion_before({.size = 30}, x, quiet)) << quiet << " " << k;
    }
  }
  std::vector<double> noise(8192);
  test::add_noise(noise, 0.1, 2);
  EXPECT_TRUE(exceeds_motion_before({.size = 0.05}, noise, 256)) << "white noise has no slow motion";
}

constexpr double kRate_Hz = 8192;
constexpr std::size_t kQuiet = 160;

double decaying_sine(double freq_Hz, double damping_ratio, double time_s) {
  const double angle = 2 * std::numbers::pi * freq_Hz * time_s;
  return std::exp(-damping_ratio * angle) * std::sin(angle);
}

/// A second of a response to a hit after kQuiet samples: a mode at 166 Hz of 0.6, a mode that decays at once, and
/// added(time after the hit).
template <class Added>
std::vector<double> response_with(Added added) {
  std::vector<double> x(8192, 0.0);
  for (std::size_t n = kQuiet; n < x.size(); ++n) {
    const double time_s = static_cast<double>(n - kQuiet) / kRate_Hz;
    x[n] = 0.6 * decaying_sine(166, 0.004, time_s) + 0.4 * decaying_sine(900, 0.01, time_s) + added(time_s);
  }
  return x;
}

// The windows of a response may follow a step by chance, where the ringing and the swing of a soft suspension are
// added.
TEST(BaselineChange, IsNoneWhereASoftSuspensionSwings) {
  struct Swing {
    double size, freq_Hz;
  };
  std::size_t like_steps = 0;
  for (const Swing& swing : {Swing{0.01, 2.5}, Swing{0.01, 3}, Swing{0.02, 2}, Swing{0.02, 2.5}, Swing{0.03, 2}}) {
    const auto x =
        response_with([&](double time_s) { return swing.size * decaying_sine(swing.freq_Hz, 0.03, time_s); });
    for (std::size_t after = 20; after < 120; ++after) {
      const RestLevels levels = rest_levels(x, kQuiet - 10, kQuiet + after);
      const auto change = find_baseline_change(levels, x.size(), 1, kRate_Hz);
      if (!change || !change->step) continue;
      ++like_steps;
      EXPECT_FALSE(keeps_its_sign(levels, x)) << swing.freq_Hz << " Hz, windows from " << after;
    }
  }
  EXPECT_GE(like_steps, 10U) << "otherwise this test shows nothing";
}

TEST(BaselineChange, IsAStepBesideASmallSwing) {
  for (const double decay_s : {0.1, 0.3, 3.0}) {
    const auto x = response_with(
        [&](double time_s) { return -0.2 * std::exp(-time_s / decay_s) + 0.01 * decaying_sine(3, 0.03, time_s); });
    std::size_t steps = 0;
    for (std::size_t after = 20; after < 120; ++after) {
      const RestLevels levels = rest_levels(x, kQuiet - 10, kQuiet + after);
      const auto change = find_baseline_change(levels, x.size(), 1, kRate_Hz);
      if (!change || !change->step) continue;
      ++steps;
      EXPECT_TRUE(keeps_its_sign(levels, x)) << decay_s << " s, windows from " << after;
    }
    EXPECT_GE(steps, 50U) << decay_s << " s";
  }
}

TEST(BaselineChange, ExceedsTheMeanOfATone) {
  EXPECT_NEAR(largest_mean(3, 50, 0.01), 3 * 2 / std::numbers::pi, 0.05) << "half a period: exactly 2/pi of it";
  EXPECT_DOUBLE_EQ(largest_mean(3, 0.1, 0.01), 3);
  EXPECT_LT(largest_mean(3, 50, 1), 0.02);
}

}  // namespace percuss::pipeline::baseline_test
