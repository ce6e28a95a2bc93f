#include "acquire/hits/clipping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "acquire/hits/pulse_shape.hpp"
#include "support/force_row.hpp"
#include "support/magnitude.hpp"

namespace percuss::acquire::clipping_test {

using std::numbers::pi;

// About eight samples per period: a peak has one or two samples at the top.
std::vector<double> fast_decay(double peak, double tau) {
  std::vector<double> x(8000);
  for (std::size_t n = 100; n < x.size(); ++n) {
    const auto t = static_cast<double>(n - 100);
    x[n] = peak * std::exp(-t / tau) * std::sin(2 * pi * t / 7.9);
  }
  return x;
}

std::size_t clipped_samples_of(const std::vector<double>& x) {
  return count_clipped_samples(x, block_extremes(x, kClippingBlock), x, 0);
}

TEST(ResolutionOf, IsTheSmallestChange) {
  EXPECT_EQ(resolution_of(std::vector<double>{0, 3, 3, 2.5, 9, 7}), 0.5);
  EXPECT_EQ(resolution_of(std::vector<double>{4, 4, 4}), 0);
  EXPECT_EQ(resolution_of(std::vector<double>{4}), 0);
  EXPECT_EQ(resolution_of({}), 0);
}

TEST(ClippedSamples, CountClippedPeaks) {
  for (const double scale : {1.0, -1.0, 1e-30, 1e30}) {
    std::vector<double> x(60);
    test::add_haversine(x, 10, 40, 100);
    std::size_t clipped = 0;
    for (double& value : x) {
      if (value >= 70) ++clipped;
      value = std::min(value, 70.0) * scale;
    }
    ASSERT_GE(clipped, 10U);
    EXPECT_EQ(clipped_samples_of(x), clipped);
  }
}

// A pulse of four samples whose upper half is clipped keeps two samples at the limit.
TEST(FlatPair, IsAClippedShortPulse) {
  for (const double sign : {1.0, -1.0}) {
    const std::vector<double> clipped{0.01, -0.02, 21.3 * sign, 90.0 * sign, 90.0 * sign, 15.2 * sign, 0.03, -0.01};
    EXPECT_TRUE(is_flat_pair(clipped, clipped));
  }
}

TEST(FlatPair, IsNoneInSmoothPulses) {
  const std::vector<double> symmetric{0.01, -0.02, 20, 90, 90, 20, 0.03, -0.01};
  EXPECT_FALSE(is_flat_pair(symmetric, symmetric)) << "a computed pulse";
  const std::vector<double> coarse{0, 0, 2.1, 9, 9, 1.5, 0.1, 0};
  EXPECT_FALSE(is_flat_pair(coarse, coarse)) << "rounding to 0.1";
  // A recorder of 12 bits at half of its range: rounding makes the two largest samples equal in some of 1000 pulses.
  std::size_t flat = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    std::vector<double> x(60);
    test::add_haversine(x, 10 + static_cast<double>(i) / 1000, 7, 1000);
    for (double& value : x) value = std::round(value);
    if (is_flat_pair(x, x)) ++flat;
  }
  EXPECT_EQ(flat, 0U);
}

TEST(ClippedSamples, CountBothLimits) {
  std::vector<double> x(4000);
  std::size_t clipped = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = std::clamp(10 * std::sin(2 * pi * (static_cast<double>(n) + 0.3) / 37.7), -8.0, 8.0);
    if (std::abs(x[n]) == 8) ++clipped;
  }
  EXPECT_EQ(clipped_samples_of(x), clipped);
}

TEST(ClippedSamples, AreNoneAtRest) {
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> x(200);
    for (std::size_t n = 50; n < 80; ++n) x[n] = sign * (3 + std::sin(0.7 * static_cast<double>(n)));  // one-sided
    EXPECT_EQ(clipped_samples_of(x), 0U);
    for (double& value : x) value = std::clamp(value, -3.1, 3.1);
    EXPECT_EQ(clipped_samples_of(x), static_cast<std::size_t>(std::count(x.begin(), x.end(), sign * 3.1)));
  }
}

TEST(ClippedSamples, AreNoneInQuantisedSmoothPeaks) {
  for (const int bits : {6, 8, 12, 16}) {
    const double steps = std::ldexp(1, bits - 1) * 0.8;
    for (double width = 6; width < 400; width *= 1.17) {
      for (const double fraction : {0.0, 0.21, 0.5, 0.83}) {
        std::vector<double> x(static_cast<std::size_t>(width) + 20);
        test::add_haversine(x, 10 + fraction, width, steps);
        for (double& value : x) value = std::round(value);
        const PulseShape pulse = shape_of_pulse(x, test::largest_sample(x));
        const auto first = static_cast<std::size_t>(pulse.rise), last = static_cast<std::size_t>(pulse.fall) + 1;
        const auto pulse_alone = std::span(x).subspan(first, last - first);
        EXPECT_EQ(count_clipped_samples(pulse_alone, block_extremes(pulse_alone, kClippingBlock), x, 0), 0U)
            << bits << ' ' << width << ' ' << fraction;
      }
    }
  }
}

TEST(ClippedSamples, AreNoneInSilenceOrShortSignals) {
  EXPECT_EQ(clipped_samples_of({}), 0U);
  EXPECT_EQ(clipped_samples_of(std::vector<double>(3, 5.0)), 0U);
  EXPECT_EQ(clipped_samples_of(std::vector<double>(100, 5.0)), 0U);
  std::vector<double> noise(10000);
  test::add_noise(noise, 1, 2);
  EXPECT_EQ(clipped_samples_of(noise), 0U);
}

TEST(ClippedSamples, CountPeaksOfAFastOscillationThatEndAtOneValue) {
  for (const double noise : {0.0, 0.01}) {
    std::vector<double> x = fast_decay(100, 300);
    test::add_noise(x, noise, 3);
    for (double& value : x) value = std::clamp(value, -80.0, 80.0);
    const auto at_limit = std::count_if(x.begin(), x.end(), [](double value) { return std::abs(value) == 80; });
    ASSERT_GT(at_limit, 8);
    EXPECT_EQ(clipped_samples_of(x), static_cast<std::size_t>(at_limit));
  }
}

TEST(ClippedSamples, AreNoneInQuantisedOscillations) {
  for (const int bits : {3, 4, 6, 8, 12, 16}) {
    for (const double tau : {50.0, 300.0, 3000.0, 1e9}) {
      for (double peak = 0.71; peak < 1; peak *= 1.013) {
        std::vector<double> x = fast_decay(peak * std::ldexp(1, bits - 1), tau);
        for (double& value : x) value = std::round(value);
        EXPECT_EQ(clipped_samples_of(x), 0U) << bits << ' ' << tau << ' ' << peak;
      }
    }
  }
}

}  // namespace percuss::acquire::clipping_test
