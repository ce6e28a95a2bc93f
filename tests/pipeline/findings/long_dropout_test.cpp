#include "pipeline/findings/long_dropout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace percuss::pipeline::long_dropout_test {

constexpr double kRate_Hz = 25600;
constexpr std::size_t kPulse = 200;  // sample at which the decay begins

/// A decaying oscillation in whole steps.
std::vector<double> decay(double freq_Hz, double damping_ratio, double amplitude_steps, std::size_t samples = 9600) {
  std::vector<double> x(samples);
  const double omega = 2 * std::numbers::pi * freq_Hz / kRate_Hz;
  for (std::size_t n = kPulse; n < samples; ++n) {
    const auto t = static_cast<double>(n - kPulse);
    x[n] = std::round(amplitude_steps * std::exp(-damping_ratio * omega * t) * std::sin(omega * t));
  }
  return x;
}

void fill(std::vector<double>& x, std::size_t first, std::size_t count, double value) {
  std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(first), count, value);
}

TEST(LongDropout, IsFoundInZerosAndInOneRepeatedValue) {
  for (const double freq_Hz : {60.0, 182.0, 1900.0, 5000.0}) {
    const std::vector<double> whole = decay(freq_Hz, 0.0005, 30000);
    for (const std::size_t first : {1003U, 2500U}) {
      for (const double value : {0.0, whole[first - 1]}) {
        std::vector<double> x = whole;
        fill(x, first, 1280, value);
        const auto found = find_long_dropout(x, kPulse);
        ASSERT_TRUE(found) << freq_Hz << " Hz, " << first << ", " << value;
        EXPECT_NEAR(static_cast<double>(found->first), static_cast<double>(first), 1);
        EXPECT_NEAR(static_cast<double>(found->count), 1280, 2);
        EXPECT_FALSE(found->to_end);
      }
    }
  }
}

TEST(LongDropout, MayLastToTheEnd) {
  std::vector<double> x = decay(182, 0.01, 30000);
  fill(x, 1500, x.size() - 1500, 0);
  const auto found = find_long_dropout(x, kPulse);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 1500U);
  EXPECT_TRUE(found->to_end);
}

// Dropouts of up to 40 samples are predicted and replaced.
TEST(LongDropout, IsLongerThanWhatCanBePredicted) {
  std::vector<double> x = decay(1900, 0.003, 30000);
  fill(x, 1003, 40, 0);
  EXPECT_FALSE(find_long_dropout(x, kPulse));
  fill(x, 1003, 41, 0);
  EXPECT_TRUE(find_long_dropout(x, kPulse));
}

// Coarse quantisation repeats one value without a dropout: zero after a decay, and the extreme value at the crests of a
// slow motion.
TEST(LongDropout, IsNotTheSilenceOfACoarseRecorder) {
  for (const double amplitude_steps : {3.0, 10.0, 100.0, 3000.0, 30000.0}) {
    for (const double damping_ratio : {0.001, 0.01, 0.05, 0.2, 0.5}) {
      for (const double freq_Hz : {5.0, 20.0, 182.0, 1900.0, 5000.0, 12000.0}) {
        std::vector<double> x = decay(freq_Hz, damping_ratio, amplitude_steps);
        EXPECT_FALSE(find_long_dropout(x, kPulse)) << amplitude_steps << ", " << damping_ratio << ", " << freq_Hz;
        const std::vector<double> other = decay(freq_Hz * 1.003, damping_ratio, amplitude_steps);
        for (std::size_t n = 0; n < x.size(); ++n) x[n] += other[n];  // beats
        EXPECT_FALSE(find_long_dropout(x, kPulse)) << "beats of " << amplitude_steps << ", " << freq_Hz;
      }
    }
  }
}

// The next blow ends the constant samples abruptly, as the end of a dropout does. But the decay had died out before.
TEST(LongDropout, IsNotTheSilenceBeforeAnotherBlow) {
  std::vector<double> x = decay(1900, 0.05, 300);
  const std::vector<double> second = decay(1900, 0.05, 30000);
  std::copy(second.begin() + kPulse, second.begin() + kPulse + 2000, x.begin() + 6000);
  EXPECT_FALSE(find_long_dropout(x, kPulse));
}

TEST(LongDropout, IsNeitherClippingNorSilenceBeforeTheDecay) {
  std::vector<double> x = decay(60, 0.003, 30000);
  for (double& sample : x) sample = std::clamp(sample, -20000.0, 20000.0);
  EXPECT_FALSE(find_long_dropout(x, kPulse));
  EXPECT_FALSE(find_long_dropout(decay(182, 0.003, 30000), 0));
  EXPECT_FALSE(find_long_dropout(std::vector<double>(1000), kPulse));
  EXPECT_FALSE(find_long_dropout({}, kPulse));
}

}  // namespace percuss::pipeline::long_dropout_test
