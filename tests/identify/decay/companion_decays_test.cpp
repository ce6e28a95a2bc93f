#include "identify/decay/companion_decays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.hpp"
#include "identify/decay/free_decay_fit.hpp"

namespace percuss::identify::companion_decays_test {

constexpr double kFs_Hz = 1000;
constexpr std::size_t kSamples = 8192;
constexpr double kNoise = 0.01;
constexpr std::pair<double, double> kBand_Hz{5, 450};
const std::vector<double> kShape{1, 0.4, -0.8, 0.6}, kOtherShape{0.5, -1, 0.7, 0.3};

struct Motion {
  std::vector<double> value;  // [samples]
  std::vector<double> shape;  // [channels]
};

DecayResults found_in(const std::vector<Motion>& motions) {
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  const std::size_t channels = motions.front().shape.size();
  FreeDecays out{.fs_Hz = kFs_Hz, .hits = 1, .channels = channels, .response = {}};
  for (std::size_t c = 0; c < channels; ++c) {
    std::vector<double> y(kSamples);
    for (std::size_t n = 0; n < kSamples; ++n) {
      for (const Motion& motion : motions) y[n] += motion.shape[c] * motion.value[n];
      y[n] += kNoise * gauss(random);
    }
    out.response.push_back(std::move(y));
  }
  return modes_of_decays(fit_free_decays(decay_spectra(out), {.band_Hz = kBand_Hz}), channels, kBand_Hz);
}

// A decay with the amplitude 1 at its start. Its frequency rises from (1 − softening) · freq_Hz to freq_Hz.
std::vector<double> decay(double freq_Hz, double damping_ratio, double softening = 0) {
  std::vector<double> value(kSamples);
  double phase = 0;
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double amplitude = std::exp(-damping_ratio * kTwoPi * freq_Hz * static_cast<double>(n) / kFs_Hz);
    value[n] = amplitude * std::sin(phase);
    phase += kTwoPi * freq_Hz * (1 - softening * amplitude * amplitude) / kFs_Hz;
  }
  return value;
}

TEST(CompanionDecays, AreOneModeWhoseFrequencyFollowsItsAmplitude) {
  const DecayResults found = found_in({{decay(100, 0.001, 0.01), kShape}, {decay(230, 0.002), kOtherShape}});
  ASSERT_EQ(found.modes.size(), 2U);
  EXPECT_GE(found.modes[0].companions.size(), 2U);
  const Mode& mode = found.modes[0].mode;
  EXPECT_GT(mode.pole.freq_Hz, 99);  // the frequency rises from 99 Hz to 100 Hz
  EXPECT_LT(mode.pole.freq_Hz, 100);
  EXPECT_GT(mode.pole.freq_Hz + 3 * mode.freq_std_Hz, 99.9);
  EXPECT_TRUE(found.modes[1].companions.empty());
  EXPECT_NEAR(found.modes[1].mode.pole.freq_Hz, 230, 4 * found.modes[1].mode.freq_std_Hz);
}

// Two decays of one shape stay two modes. Three decays of three shapes stay three modes.
TEST(CompanionDecays, LeavePairsAndOtherShapes) {
  EXPECT_EQ(found_in({{decay(100, 0.003), kShape}, {decay(101.5, 0.003), kShape}}).modes.size(), 2U);
  const DecayResults three =
      found_in({{decay(100, 0.003), kShape}, {decay(101.5, 0.003), kOtherShape}, {decay(102.5, 0.003), {1, 1, 1, -1}}});
  EXPECT_EQ(three.modes.size(), 3U);
}

// The frequency rises from 99 Hz to 100 Hz. The sum of the parts falls without beats while its frequency rises.
TEST(CompanionDecays, AreOneModeInOneOrTwoChannelsIfTheirSumDoesNotBeat) {
  for (const std::vector<double>& shape : {std::vector<double>{1}, std::vector<double>{1, -0.7}}) {
    const DecayResults found = found_in({{decay(100, 0.002, 0.01), shape}});
    ASSERT_EQ(found.modes.size(), 1U);
    EXPECT_GE(found.modes[0].companions.size(), 2U);
    EXPECT_TRUE(found.modes[0].unresolved_Hz.empty());
    const Mode& mode = found.modes[0].mode;
    EXPECT_GT(mode.pole.freq_Hz, 99);
    EXPECT_LT(mode.pole.freq_Hz, 100);
    EXPECT_GT(mode.pole.freq_Hz + 3 * mode.freq_std_Hz, 99.9);
  }
}

// Three real modes within a bandwidth (0.6 Hz) and of like damping: one channel cannot tell them from parts of a decay.
TEST(CompanionDecays, AreNamedInOneChannelIfTheyMayBeModes) {
  const DecayResults found =
      found_in({{decay(99.5, 0.003), {0.7}}, {decay(100, 0.003), {1}}, {decay(100.5, 0.003), {0.7}}});
  ASSERT_EQ(found.modes.size(), 3U);
  for (const DecayMode& mode : found.modes) EXPECT_TRUE(mode.companions.empty());
  ASSERT_EQ(found.modes[1].unresolved_Hz.size(), 2U);
  EXPECT_NEAR(found.modes[1].unresolved_Hz[0], 99.5, 4 * found.modes[0].mode.freq_std_Hz);
  EXPECT_NEAR(found.modes[1].unresolved_Hz[1], 100.5, 4 * found.modes[2].mode.freq_std_Hz);
  EXPECT_TRUE(found.modes[0].unresolved_Hz.empty());
  EXPECT_TRUE(found.modes[2].unresolved_Hz.empty());
}

// In one channel, a pair within a bandwidth and three modes farther apart are modes without a remark.
TEST(CompanionDecays, LeavePairsAndChordsInOneChannel) {
  const DecayResults pair = found_in({{decay(100, 0.003), {1}}, {decay(100.4, 0.004), {0.7}}});
  const DecayResults chord =
      found_in({{decay(100, 0.003), {1}}, {decay(101.5, 0.003), {0.7}}, {decay(103, 0.003), {0.7}}});
  EXPECT_EQ(pair.modes.size(), 2U);
  EXPECT_EQ(chord.modes.size(), 3U);
  for (const DecayResults* found : {&pair, &chord}) {
    for (const DecayMode& mode : found->modes)
      EXPECT_TRUE(mode.companions.empty() && mode.unresolved_Hz.empty()) << mode.mode.pole.freq_Hz;
  }
}

// A fit result of three decays at 100 Hz whose amplitudes in two hits are the powers of the hits' strength: the parts
// of exp(−σt) exp(jε exp(−σt)). One hit whose amplitudes cancel at some time is enough to keep three modes.
TEST(CompanionDecays, AddUpInEachHit) {
  constexpr double kDamping = 0.002, kPhase = 0.8;
  const auto result = [](const std::vector<std::vector<Complex>>& of_hits) {
    DecayResults out;
    for (std::size_t k = 0; k < 3; ++k) {
      const double order = static_cast<double>(k) + 1;
      DecayMode mode;
      mode.mode.pole = decay_rate_of({.freq_Hz = 100, .damping_ratio = kDamping}).pole();
      mode.mode.pole.damping_ratio *= order;
      mode.mode.residues.push_back({.point = 0, .channel = 0, .value = 1, .std = 0, .own_pole = {}});
      mode.energy = 1e4 / order;
      for (const std::vector<Complex>& hit : of_hits) mode.hits.push_back({.value = hit[k], .std = 1e-4});
      out.modes.push_back(mode);
    }
    gather_companions(out);
    return out;
  };
  const auto of_strength = [](double strength) {
    const Complex step = Complex(0, kPhase) * strength;
    return std::vector<Complex>{strength, strength * step, strength * step * step / 2.0};
  };
  const DecayResults one = result({of_strength(1), of_strength(0.6)});
  ASSERT_EQ(one.modes.size(), 1U);
  EXPECT_EQ(one.modes[0].companions.size(), 2U);
  // x − 1.9 x² + 0.4 x³ with x = exp(−σt) is 0 once between x = 0 and x = 1, where the amplitude rises again.
  const DecayResults three = result({of_strength(1), {1.0, -1.9, 0.4}});
  EXPECT_EQ(three.modes.size(), 3U);
}

}  // namespace percuss::identify::companion_decays_test
