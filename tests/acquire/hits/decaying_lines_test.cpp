#include "acquire/hits/decaying_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/units.hpp"
#include "support/force_row.hpp"

namespace percuss::acquire::decaying_lines_test {

constexpr std::size_t kSamples = 60000;
constexpr std::size_t kLength = 12000;
constexpr RelativeBand kBand{.low = 0.0025, .high = 0.1};

struct Decay {
  double turns = 0.007;  // per sample
  double tau = 3000;     // samples
  double peak = 50;
};

std::vector<double> noise(std::uint64_t seed, double std = 1) {
  std::vector<double> x(kSamples);
  test::add_noise(x, std, seed);
  return x;
}

// Adds a decay that begins at sample 0.
void add_decay(std::vector<double>& x, const Decay& decay) {
  for (std::size_t n = 0; n < x.size(); ++n) {
    const auto t = static_cast<double>(n);
    x[n] += decay.peak * std::exp(-t / decay.tau) * std::sin(kTwoPi * decay.turns * t);
  }
}

void add_hum(std::vector<double>& x, double turns, double size, double phase = 0.3) {
  for (std::size_t n = 0; n < x.size(); ++n) x[n] += size * std::sin(kTwoPi * turns * static_cast<double>(n) + phase);
}

bool decays(const std::vector<double>& x, std::size_t length = kLength, const RelativeBand& band = kBand) {
  return has_decaying_lines(length, x.size(), band,
                            [&](std::size_t first, std::size_t count) { return std::span(x).subspan(first, count); });
}

TEST(HasDecayingLines, IsFalseForNoise) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) EXPECT_FALSE(decays(noise(seed))) << seed;
}

TEST(HasDecayingLines, IsFalseForNoiseThatFallsWithFrequency) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    std::vector<double> x = noise(seed);
    double sum = 0;
    for (double& value : x) value = sum = 0.98 * sum + value;
    EXPECT_FALSE(decays(x)) << seed;
  }
}

TEST(HasDecayingLines, IsFalseForSteadySinusoids) {
  for (const double size : {1.0, 100.0}) {
    for (const double phase : {0.0, 1.0, 2.0}) {
      std::vector<double> x = noise(1);
      add_hum(x, 50 / 25600.0, size, phase);
      add_hum(x, 150 / 25600.0, size, phase);
      EXPECT_FALSE(decays(x)) << size << ' ' << phase;
    }
  }
}

// At sample kLength, the mode's amplitude is 0.9 standard deviations of the noise.
TEST(HasDecayingLines, IsTrueForAModeBelowTheLevelOfTheNoise) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<double> x = noise(seed);
    add_decay(x, {});
    EXPECT_TRUE(decays(x)) << seed;
  }
}

TEST(HasDecayingLines, IsTrueForAModeThatIsQuieterThanHumBesideIt) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<double> x = noise(seed);
    add_decay(x, {.turns = 0.007});
    add_hum(x, 150 / 25600.0, 10, static_cast<double>(seed));
    EXPECT_TRUE(decays(x)) << seed;
  }
}

TEST(HasDecayingLines, IsFalseOnceTheModeHasDecayed) {
  std::vector<double> x = noise(1);
  add_decay(x, {.tau = 1000});
  EXPECT_TRUE(decays(x, 3000));
  EXPECT_FALSE(decays(x));
}

TEST(HasDecayingLines, IgnoresModesOutsideTheBand) {
  std::vector<double> x = noise(1);
  add_decay(x, {.turns = 0.2});
  EXPECT_FALSE(decays(x));
  EXPECT_TRUE(decays(x, kLength, {.low = 0.0025, .high = 0.3}));
}

TEST(HasDecayingLines, IsTrueWhereTooFewSamplesFollowToTell) {
  const std::vector<double> x = noise(1);
  EXPECT_TRUE(decays(x, kSamples - 1000));
  EXPECT_TRUE(decays(x, kLength, {.low = 1e-9, .high = 0.1}));
  EXPECT_FALSE(decays(x, kSamples));
}

}  // namespace percuss::acquire::decaying_lines_test
