#include "pipeline/response/usable_decay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "pipeline/response/response_test.hpp"
#include "support/response_records.hpp"

namespace percuss::pipeline::usable_decay_test {

using testing::Contains;
using testing::Field;

constexpr double kFs_Hz = 8192;
constexpr identify::Pole kPole{600, 0.002};
constexpr std::size_t kLead = 1000, kEach = 12000;

// Free decays of one mode that begin at kLead and every kEach samples, as a recorder of 16 bits with a limit of 1
// stores them.
std::vector<double> decays(double amplitude, std::size_t blows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  const Complex s = identify::decay_rate_of(kPole).rate_radps;
  std::vector<double> x(kLead + blows * kEach);
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (n >= kLead) x[n] = amplitude * std::exp(s * (static_cast<double>((n - kLead) % kEach) / kFs_Hz)).imag();
    x[n] = std::round(32767 * std::clamp(x[n] + 2e-4 * gauss(random), -1.0, 1.0)) / 32767;
  }
  return x;
}

void expect_the_mode(const ResponseTest& test) {
  ASSERT_EQ(test.found.modes.size(), 1U);
  const identify::Mode& mode = test.found.modes[0].mode;
  EXPECT_NEAR(mode.pole.freq_Hz, kPole.freq_Hz, 4 * mode.freq_std_Hz);
  EXPECT_NEAR(mode.pole.damping_ratio, kPole.damping_ratio, 4 * mode.damping_std);
}

TEST(UsableDecay, BeginsAfterClippedSamples) {
  const ResponseTest test =
      analyse_responses(test::response_record(kFs_Hz, {{decays(3, 2, 1)}}, 0, true), {.threads = 1});
  ASSERT_EQ(test.hits.size(), 2U);
  // 3 exp(−7.54 t/s) falls to 1 in 0.146 s. With 13.7 samples per period, the largest sample is up to 2.6 % below
  // the crest; the decay falls by that much in 3.5 ms.
  EXPECT_NEAR(test.hits[0].clipped_s, 0.146, 0.005);
  EXPECT_THAT(test.warnings, Contains(Field(&Warning::code, "response_clipped")));
  expect_the_mode(test);
}

TEST(UsableDecay, EndsWhereANoiseGateCloses) {
  std::vector<double> x = decays(0.8, 2, 2);
  for (const std::size_t start : {kLead, kLead + kEach})
    std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(start + 4000), kEach - 4000 - 500, 0.0);
  const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {{x}}, 0, true), {.threads = 1});
  ASSERT_EQ(test.hits.size(), 2U);
  EXPECT_TRUE(test.hits[0].gated);
  EXPECT_THAT(test.warnings, Contains(Field(&Warning::code, "cut_decay")));
  expect_the_mode(test);
}

// A decay into the quantisation of a quiet recorder is no gate.
TEST(UsableDecay, KeepsADecayIntoSilence) {
  const Complex s = identify::decay_rate_of({600, 0.02}).rate_radps;
  std::vector<double> x(kLead + kEach);
  for (std::size_t n = kLead; n < x.size(); ++n)
    x[n] = std::round(32767 * 0.8 * std::exp(s * (static_cast<double>(n - kLead) / kFs_Hz)).imag()) / 32767;
  const acquire::Record record = test::response_record(kFs_Hz, {{x}}, 0, true);
  const UsableDecay usable = usable_decay(record, {.row = 0, .first = kLead, .end = x.size()});
  EXPECT_FALSE(usable.gated);
  EXPECT_EQ(usable.end, x.size());
}

// A knock within one of three decays: that hit is left out.
TEST(UsableDecay, LeavesOutADisturbedHit) {
  std::vector<double> x = decays(0.8, 3, 3);
  std::mt19937 random(4);
  std::normal_distribution<double> gauss;
  for (std::size_t n = 0; n < 400; ++n)
    x[kLead + kEach + 6000 + n] += 0.003 * gauss(random) * std::sin(std::numbers::pi * static_cast<double>(n) / 400);
  const ResponseTest test = analyse_responses(test::response_record(kFs_Hz, {{x}}, 0, true), {.threads = 1});
  ASSERT_EQ(test.hits.size(), 3U);
  EXPECT_TRUE(test.hits[0].accepted);
  EXPECT_FALSE(test.hits[1].accepted);
  EXPECT_THAT(test.hits[1].reason, testing::HasSubstr("after the impact"));
  EXPECT_TRUE(test.hits[2].accepted);
  expect_the_mode(test);
}

}  // namespace percuss::pipeline::usable_decay_test
