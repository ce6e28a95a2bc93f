#include "pipeline/response/response_impacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "core/units.hpp"
#include "pipeline/response/response_test.hpp"
#include "support/response_records.hpp"

// The tests with a slow mode also judge the onset by the modes that are fitted to the decay after it.
namespace percuss::pipeline::response_impacts_test {

constexpr double kFs_Hz = 8192;

// A row with the free decay of a slow mode of amplitude 1 from 0.1 s on.
constexpr identify::Pole kSlow{40, 0.05};
std::vector<double> slow_decay(double noise, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const Complex s = identify::decay_rate_of(kSlow).rate_radps;
  std::vector<double> x(8192);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t_s = static_cast<double>(n) / kFs_Hz - 0.1;
    x[n] = 0.5 + noise * gauss(random) + (t_s < 0 ? 0 : std::exp(s * t_s).real());
  }
  return x;
}

// A slow mode ten times above the noise: noise hides the blow in the differences of the samples, but not in the
// samples. A fit that begins before the blow biases the damping ratio.
TEST(ResponseImpacts, FindsAWeakBlowOnASlowMode) {
  constexpr unsigned kSeeds = 60;
  double sum = 0, squares = 0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    std::mt19937 random(seed);
    const ResponseTest test =
        analyse_responses(test::response_record(kFs_Hz, {{slow_decay(0.1, random)}}, 0, false), {});
    ASSERT_FALSE(test.hits.empty()) << seed;
    EXPECT_NEAR(test.hits[0].onset_s, 0.1, 2e-3) << seed;
    const auto near = std::find_if(test.found.modes.begin(), test.found.modes.end(),
                                   [](const auto& m) { return std::abs(m.mode.pole.freq_Hz - kSlow.freq_Hz) < 4; });
    ASSERT_NE(near, test.found.modes.end()) << seed;
    const double z = (near->mode.pole.damping_ratio - kSlow.damping_ratio) / near->mode.damping_std;
    sum += z;
    squares += z * z;
  }
  EXPECT_NEAR(sum / kSeeds, 0, 0.39);                 // three standard deviations of the mean of 60 values
  EXPECT_NEAR(std::sqrt(squares / kSeeds), 1, 0.28);  // and of their RMS
}

// The constant part of the signal is no sign of a second mode. With these two of 400 seeds, a fit that takes it for a
// second mode finds no mode.
TEST(ResponseImpacts, IsNotSplitByAConstant) {
  for (const unsigned seed : {231U, 351U}) {
    std::mt19937 random(seed);
    const ResponseTest test =
        analyse_responses(test::response_record(kFs_Hz, {{slow_decay(0.1, random)}}, 0, false), {});
    ASSERT_EQ(test.found.modes.size(), 1U) << seed;
    EXPECT_NEAR(test.found.modes[0].mode.pole.freq_Hz, kSlow.freq_Hz, 4 * test.found.modes[0].mode.freq_std_Hz);
  }
}

// In a row that shows no blow, the blow may lie anywhere. Such a row is not used if other rows show their blows.
TEST(ResponseImpacts, RejectsRowsWithoutABlowIfOthersShowOne) {
  std::mt19937 random(1);
  const ResponseTest test = analyse_responses(
      test::response_record(kFs_Hz, {{slow_decay(0.01, random)}, {slow_decay(2, random)}}, 0, false), {});
  ASSERT_EQ(test.hits.size(), 2U);
  EXPECT_TRUE(test.hits[0].accepted);
  EXPECT_FALSE(test.hits[1].accepted);
  EXPECT_EQ(test.found.modes.size(), 1U);
}

// At 48 kHz, the differences of single samples are the microphone's noise. A finger tap rises in a millisecond: over
// several blocks, none of which is ten times the block before it.
TEST(ResponseImpacts, FindsSoftTapsInWhiteNoiseAtAHighRate) {
  constexpr double kPhone_Hz = 48000;
  constexpr std::size_t kLead = 20000, kEach = 40000, kContact = 96;
  const Complex step = std::exp(identify::decay_rate_of({300, 0.01}).rate_radps / kPhone_Hz);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<double> x(kLead + 3 * kEach);
    Complex motion = 0;
    for (std::size_t n = 0; n < x.size(); ++n) {
      const std::size_t since = n < kLead ? kEach : (n - kLead) % kEach;
      const double phase = kTwoPi * static_cast<double>(since) / kContact;
      motion = step * motion + (since < kContact ? (1 - std::cos(phase)) / kContact : 0);
      x[n] = motion.real() + 0.01 * gauss(random);
    }
    const auto found = response_impacts(test::response_record(kPhone_Hz, {{x}}, 0, true), {});
    ASSERT_EQ(found.size(), 3U) << seed;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto start = static_cast<double>(kLead + i * kEach);
      EXPECT_GE(static_cast<double>(found[i].first), start) << seed;
      EXPECT_LT(static_cast<double>(found[i].first), start + kContact) << seed;
    }
  }
}

// A tap whose first motion does not stand out of the noise, but whose ringing does. If a tap within the decay of
// another one is missed, the fit finds a comb of false modes.
TEST(ResponseImpacts, FindsWeakTapsInNoise) {
  constexpr double kPhone_Hz = 44100;
  constexpr std::size_t kLead = 30000, kEach = 60000;
  const Complex s = identify::decay_rate_of({800, 0.002}).rate_radps;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<double> x(kLead + 3 * kEach);
    for (std::size_t n = 0; n < x.size(); ++n) {
      if (n >= kLead) x[n] = std::exp(s * (static_cast<double>((n - kLead) % kEach) / kPhone_Hz)).imag();
      x[n] += 0.2 * gauss(random);
    }
    const auto found = response_impacts(test::response_record(kPhone_Hz, {{x}}, 0, true), {});
    EXPECT_EQ(found.size(), 3U) << seed;
  }
}

// A row without a rise holds no impact, or begins after it. Only noise is quiet.
TEST(ResponseImpacts, TellsNoiseFromADecayThatBeganBeforeTheRow) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    std::vector<double> noise(2 * 8192), decay;
    double drift = 0;
    for (double& value : noise) {
      drift = 0.99 * drift + 0.1 * gauss(random);  // most of the noise lies below 15 Hz
      value = drift + 0.1 * gauss(random);
    }
    decay = noise;
    const Complex s = identify::decay_rate_of({800, 0.001}).rate_radps;
    for (std::size_t n = 0; n < decay.size(); ++n)
      decay[n] += 5 * std::exp(s * (static_cast<double>(n) / kFs_Hz)).real();
    for (const auto& [row, quiet] : {std::pair(noise, true), std::pair(decay, false)}) {
      const auto found = response_impacts(test::response_record(kFs_Hz, {{row}}, 0, false), {});
      ASSERT_EQ(found.size(), 1U) << seed;
      EXPECT_FALSE(found[0].whole_pulse) << seed;
      EXPECT_EQ(found[0].quiet, quiet) << seed;
    }
  }
}

}  // namespace percuss::pipeline::response_impacts_test
