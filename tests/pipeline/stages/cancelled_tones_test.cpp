#include "pipeline/stages/cancelled_tones.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "identify/identify.hpp"
#include "pipeline/stages/hidden_modes.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::pipeline::cancelled_tones_test {

constexpr std::array<identify::Pole, 2> kModes = {
    {{.freq_Hz = 591, .damping_ratio = 0.0066}, {.freq_Hz = 598, .damping_ratio = 0.0077}}};
constexpr std::array<std::array<double, 2>, 2> kResidues = {{{1, 0.5}, {-0.4, 1}}};  // [modes][channels]
constexpr double kTone_Hz = 641, kNoise = 0.02;
constexpr std::size_t kHits = 5;
constexpr double kDeviations = 5;  // of four real and four complex values: one false alarm in 58 000

// Hits of one point under a tone whose phase wanders: at each line it has another phase, and its size falls with the
// distance from its frequency. It reaches the channels with one ratio, 1 to `ratio`.
struct HitsUnderATone {
  identify::FrfDataset set = test::empty_set(2000, 2000, 10, 990, 2);
  identify::HitFrfs frfs{.set = {.lines = set.lines, .usable_bandwidth_Hz = set.usable_bandwidth_Hz}};
  std::vector<std::vector<Complex>> spectra;

  HitsUnderATone(double size, Complex ratio) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (std::size_t h = 0; h < kHits; ++h) {
      identify::FrfDataset one = test::empty_set(2000, 2000, 10, 990, 2);
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t m = 0; m < 2; ++m) test::add_mode(one, c, kModes[m], kResidues[m][c]);
      test::add_frf_noise(one, kNoise, h + 1);
      const Complex* const force = one.points.front().spectra.front().get();
      for (std::size_t k = 0; k < one.lines.count; ++k) {
        const double apart_Hz = one.lines.freq_Hz(k) - kTone_Hz;
        const double real = normal(random), imaginary = normal(random);
        const Complex tone = size * Complex(real, imaginary) / std::hypot(1, apart_Hz);
        one.channels[0].frf[k] += tone;
        one.channels[1].frf[k] += tone * ratio;
        for (std::size_t c = 0; c < 2; ++c) {
          set.channels[c].frf[k] += one.channels[c].frf[k] / static_cast<double>(kHits);
          one.channels[c].frf[k] *= force[k];
        }
      }
      frfs.set.points.push_back(one.points.front());
      frfs.points.push_back(0);
      for (std::size_t c = 0; c < 2; ++c) {
        frfs.set.channels.push_back({.point = h, .channel = c, .frf = {}});
        spectra.push_back(one.channels[c].frf);
      }
    }
    frfs.accel.assign(spectra.begin(), spectra.end());
  }
};

void expect_both_modes(const std::vector<identify::Mode>& modes) {
  ASSERT_EQ(modes.size(), 2U);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_NEAR(modes[m].pole.freq_Hz, kModes[m].freq_Hz, kDeviations * modes[m].freq_std_Hz);
    EXPECT_NEAR(modes[m].pole.damping_ratio, kModes[m].damping_ratio, kDeviations * modes[m].damping_std);
    ASSERT_EQ(modes[m].residues.size(), 2U);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(std::abs(modes[m].residues[c].value - kResidues[m][c]), 0, kDeviations * modes[m].residues[c].std);
  }
}

TEST(CancelledTones, FindTheModesThatATonesFlankHides) {
  const HitsUnderATone test(1000, std::polar(1.0, 1.1));
  std::vector<identify::Mode> modes = identify::identify_modes(test.set);
  ASSERT_LT(modes.size(), 2U);  // the flank at 600 Hz is a fifth of the peaks, and scatters from line to line
  refit_modes_near_tones(modes, {{.freq_Hz = 640, .wanders = true}}, test.set, test.frfs, identify::Effort::best);
  expect_both_modes(modes);
  EXPECT_LT(modes[0].freq_std_Hz, 0.05);
}

// Under a weaker tone, the identification already finds both modes; the refit finds them with smaller standard
// deviations.
TEST(CancelledTones, TakeTheValuesWithTheSmallerStandardDeviation) {
  const HitsUnderATone test(100, std::polar(1.0, 1.1));
  const std::vector<identify::Mode> before = identify::identify_modes(test.set);
  std::vector<identify::Mode> modes = before;
  refit_modes_near_tones(modes, {{.freq_Hz = 640, .wanders = true}}, test.set, test.frfs, identify::Effort::best);
  ASSERT_EQ(before.size(), 2U);
  expect_both_modes(modes);
  for (std::size_t m = 0; m < 2; ++m) EXPECT_LT(modes[m].freq_std_Hz, 0.7 * before[m].freq_std_Hz);
}

TEST(CancelledTones, ChangeNothingWithoutATone) {
  const HitsUnderATone test(0, 1);
  const std::vector<identify::Mode> before = identify::identify_modes(test.set);
  std::vector<identify::Mode> modes = before;
  refit_modes_near_tones(modes, {{.freq_Hz = 640, .wanders = true}}, test.set, test.frfs, identify::Effort::best);
  refit_modes_near_tones(modes, {{.freq_Hz = 640}}, test.set, test.frfs, identify::Effort::best);
  ASSERT_EQ(modes.size(), before.size());
  for (std::size_t m = 0; m < modes.size(); ++m) EXPECT_EQ(modes[m].pole, before[m].pole);
}

// The force explains the peaks of the modes, but not that of the tone.
TEST(CancelledTones, KnowATonesPeak) {
  const HitsUnderATone test(1000, std::polar(1.0, 1.1));
  const auto tones = tones_at({kTone_Hz, 591}, test.set, test.frfs);
  ASSERT_EQ(tones.size(), 1U);
  EXPECT_EQ(tones[0].freq_Hz, kTone_Hz);
  EXPECT_TRUE(tones[0].wanders);
}

TEST(CancelledTones, NeedTwoChannelsAndThreeHits) {
  HitsUnderATone test(1000, std::polar(1.0, 1.1));
  EXPECT_TRUE(can_cancel_tones(test.set, test.frfs));
  identify::HitFrfs two = test.frfs;
  two.points.resize(2);
  EXPECT_FALSE(can_cancel_tones(test.set, two));
  test.set.channels.resize(1);
  EXPECT_FALSE(can_cancel_tones(test.set, test.frfs));
}

}  // namespace percuss::pipeline::cancelled_tones_test
