#include "identify/decay/decay_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"

namespace percuss::identify::decay_start_test {

constexpr double kFs_Hz = 48000;
constexpr std::size_t kSamples = 24000, kSafe = 960;  // 20 ms
constexpr Pole kPole{441, 0.01};

// The response of one mode to a force that acts from sample 0 on and ends at `end`, with noise that falls with the
// frequency.
FreeDecays tap(std::size_t end, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  const Complex step = std::exp(decay_rate_of(kPole).rate_radps / kFs_Hz);
  std::vector<double> y(kSamples);
  Complex motion = 0;
  double now = 0;
  for (int n = 0; n < 2000; ++n) now = 0.97 * now + gauss(random);
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double phase = kTwoPi * (static_cast<double>(n) + 0.5) / static_cast<double>(end);
    motion = step * motion + (n < end ? 1 - std::cos(phase) : 0);
    now = 0.97 * now + gauss(random);
    y[n] = motion.real() / static_cast<double>(end) + noise * now;
  }
  return {.fs_Hz = kFs_Hz, .hits = 1, .channels = 1, .response = {y}};
}

// A soft tip's force ends slowly, and a fit that begins while it acts is biased. Noise alone must not delay the start,
// although the noise of neighbouring blocks of a few samples is correlated.
TEST(DecayStart, IsTheEndOfASoftForceInColouredNoise) {
  constexpr std::size_t kEnd = 96;  // 2 ms
  double squares = 0;
  constexpr unsigned kSeeds = 20;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const StartedFit found = fit_from_earliest_start(tap(kEnd, 2e-4, seed), kSafe, {.band_Hz = {50, 5000}});
    ASSERT_EQ(found.fit.decays.size(), 1U) << seed;
    EXPECT_GE(found.start, kEnd) << seed;
    EXPECT_LE(found.start, 2 * kEnd) << seed;
    const FittedDecay& decay = found.fit.decays[0];
    squares += std::pow((decay.rate.rate_radps - decay_rate_of(kPole).rate_radps).real(), 2) / decay.covariance(0, 0);
  }
  EXPECT_NEAR(std::sqrt(squares / kSeeds), 1, 0.48);  // three standard deviations of 20 values
}

TEST(DecayStart, IsTheFirstSampleWithoutAForce) {
  FreeDecays decay = tap(1, 2e-4, 1);
  EXPECT_LE(fit_from_earliest_start(decay, kSafe, {.band_Hz = {50, 5000}}).start, 1U);
}

}  // namespace percuss::identify::decay_start_test
