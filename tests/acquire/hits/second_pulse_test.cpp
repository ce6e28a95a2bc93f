#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "acquire/hits/further_force.hpp"
#include "support/force_row.hpp"
#include "support/magnitude.hpp"

namespace percuss::acquire::second_pulse_test {

constexpr std::size_t kSamples = 6000;

/// The largest further contact.
std::optional<SecondPulse> second_in(const std::vector<double>& x, double noise_N = 0) {
  const PulseShape pulse = shape_of_pulse(x, test::largest_sample(x));
  const FurtherForce found = further_force(x, pulse, gate_around(x, pulse, noise_N), noise_N);
  const auto largest = std::max_element(found.contacts.begin(), found.contacts.end(),
                                        [](const SecondPulse& a, const SecondPulse& b) { return a.ratio < b.ratio; });
  return largest == found.contacts.end() ? std::nullopt : std::optional(*largest);
}

/// Two pulses of one width in samples, the second `delay` after the first (before it, when negative).
std::vector<double> two_pulses(double width, double delay, double ratio, double scale = 300) {
  std::vector<double> x(kSamples);
  test::add_filtered_haversine(x, 2500.37, width, scale);
  test::add_filtered_haversine(x, 2500.37 + delay, width, ratio * scale);
  return x;
}

/// The largest sample lies up to half a sample from the peak. It is lower than the peak by 1 − cos²(π/(2 width)), about
/// (π/(2 width))². The 0.01 allows for the ringing of one pulse in the other. It also allows for the smoothing, a mean
/// over about half a pulse, which depends on where the samples lie in the pulse.
double ratio_slack(double width) { return std::pow(std::numbers::pi / 2 / width, 2) + 0.01; }

TEST(SecondPulse, IsFoundWithItsDelayAndRatio) {
  constexpr double kDelay = 1;  // samples: each peak is within half a sample of the true one
  for (const double width : {6.0, 7.7, 20.0, 60.0}) {
    for (const double delay : {4.1 * width + 20, 1000.0, -1777.7, -4.0 * width - 21.3}) {
      for (const double ratio : {0.02, 0.1, 0.35, 0.9}) {
        const auto second = second_in(two_pulses(width, delay, ratio));
        ASSERT_TRUE(second) << width << ' ' << delay << ' ' << ratio;
        EXPECT_LE(std::abs(second->delay_samples - delay), kDelay) << width << ' ' << delay << ' ' << ratio;
        EXPECT_LE(std::abs(second->ratio / ratio - 1), ratio_slack(width)) << width << ' ' << delay << ' ' << ratio;
      }
    }
  }
}

TEST(SecondPulse, IsFoundSoonAfterTheFirst) {
  const auto second = second_in(two_pulses(8, 30, 0.3));  // 1.2 ms at 25.6 kHz
  ASSERT_TRUE(second);
  EXPECT_LE(std::abs(second->delay_samples - 30), 1);
  EXPECT_LE(std::abs(second->ratio / 0.3 - 1), ratio_slack(8));
}

TEST(SecondPulse, DoesNotDependOnUnitOrSign) {
  const auto plain = second_in(two_pulses(8, 300, 0.2));
  ASSERT_TRUE(plain);
  for (const double scale : {-300.0, 300 * 0x1p-100, -300 * 0x1p100}) {
    const auto second = second_in(two_pulses(8, 300, 0.2, scale));
    ASSERT_TRUE(second);
    EXPECT_EQ(second->delay_samples, plain->delay_samples);
    EXPECT_DOUBLE_EQ(second->ratio, plain->ratio);
  }
}

TEST(SecondPulse, IsTheLargestOfSeveral) {
  auto x = two_pulses(8, 300, 0.2);
  test::add_filtered_haversine(x, 2500.37 + 800, 8, 300 * 0.3);
  test::add_filtered_haversine(x, 2500.37 - 700, 8, 300 * 0.1);
  const auto second = second_in(x);
  ASSERT_TRUE(second);
  EXPECT_LE(std::abs(second->delay_samples - 800), 1);
}

TEST(SecondPulse, IsNotTheRingingOfTheAntiAliasFilter) {
  for (double width = 2; width < 60; width *= 1.3) {
    for (const double fraction : {0.0, 0.25, 0.5, 0.9}) {
      std::vector<double> x(kSamples);
      test::add_filtered_haversine(x, 3000 + fraction, width, 1000);
      EXPECT_FALSE(second_in(x)) << width << ' ' << fraction;
    }
  }
}

TEST(SecondPulse, IsNotNoise) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const double noise : {1e-4, 1e-2, 0.05}) {
      std::vector<double> x(kSamples);
      test::add_filtered_haversine(x, 3000, 8, 1);
      test::add_noise(x, noise, seed);
      EXPECT_FALSE(second_in(x, noise)) << seed << ' ' << noise;
    }
  }
}

TEST(SecondPulse, IsFoundInNoise) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    auto x = two_pulses(8, 400, 0.1, 1);
    test::add_noise(x, 0.005, seed);
    const auto second = second_in(x, 0.005);
    ASSERT_TRUE(second);
    // Within two samples of its peak, a pulse of 0.1 falls by more than the noise of 0.005, so noise rarely
    // moves the largest sample further.
    EXPECT_LE(std::abs(second->delay_samples - 400), 3);
    // Four standard deviations of the noise, and the offset of the largest sample from each peak.
    EXPECT_LE(std::abs(second->ratio - 0.1), 0.02);
  }
}

TEST(SecondPulse, IsNotTheUndershootOfAnAcCoupledChannel) {
  for (const double time_constant : {10.0, 50.0, 300.0, 3000.0}) {
    std::vector<double> x(kSamples);
    test::add_filtered_haversine(x, 3000, 8, 300);
    const auto coupled = test::ac_coupled(x, time_constant);
    ASSERT_LE(*std::min_element(coupled.begin() + 3010, coupled.end()), -0.2);  // the coupling makes an undershoot
    EXPECT_FALSE(second_in(coupled)) << time_constant;
    if (time_constant < 50) continue;
    // Two couplings make an overshoot. It is smaller for longer time constants.
    EXPECT_FALSE(second_in(test::ac_coupled(coupled, time_constant))) << time_constant;
  }
}

TEST(SecondPulse, IsFoundInTheUndershootOfAnAcCoupledChannel) {
  const auto second = second_in(test::ac_coupled(two_pulses(8, 200, 0.3), 300));
  ASSERT_TRUE(second);
  EXPECT_LE(std::abs(second->delay_samples - 200), 1);
}

TEST(SecondPulse, IsNotFoundBesideALonePulse) {
  for (const std::vector<double>& x : {std::vector<double>{5}, {5, 4}, {0, 5}, {0, 0, 5}, {5, 0, 0}, {1, 5, 1}}) {
    EXPECT_FALSE(second_in(x));
  }
}

}  // namespace percuss::acquire::second_pulse_test
