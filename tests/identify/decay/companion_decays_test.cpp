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

// With two channels at a right angle, both hoop modes of a tube have the ratio of residues −1, whatever their planes.
// An equal ratio is then no proof of one shape.
TEST(CompanionDecays, NeedThreeChannels) {
  const DecayResults found = found_in({{decay(100, 0.001, 0.01), {1, -1}}});
  EXPECT_GT(found.modes.size() + found.tones.size(), 1U);
}

}  // namespace percuss::identify::companion_decays_test
