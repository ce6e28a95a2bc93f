#include "pipeline/stages/tone_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/hits_with_phases.hpp"

namespace percuss::pipeline::tone_modes_test {

const std::vector<Tone> kHum = {{.freq_Hz = 49.99}, {.freq_Hz = 120.3}};

std::size_t modes_left(double freq_Hz, double half_power_Hz, std::size_t hits, double turns,
                       const std::vector<Tone>& tones = kHum) {
  const test::HitsWithPhases test(test::mode_at(freq_Hz, half_power_Hz, 1), hits, turns);
  std::vector<identify::Mode> modes = {test.strong, test.weak_mean};
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  remove_tone_modes(modes, tones, test.set, [&]() -> const identify::HitFrfs& { return test.frfs; });
  return modes.size();
}

// 0.23 turns from hit to hit leave 0.14 of the residue in the mean of five hits, and a coherence of 0.02. The flank of
// the strong mode follows the force at every line.
TEST(ToneModes, RemovesANarrowHarmonicWhoseResiduesDoNotFollowTheForce) {
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23), 1U);
}

TEST(ToneModes, KeepsWhatFollowsTheForce) { EXPECT_EQ(modes_left(449.8, 0.9, 5, 0), 2U); }

TEST(ToneModes, KeepsModesBesideHarmonicsAndBroadModes) {
  EXPECT_EQ(modes_left(461, 0.9, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(449.8, 3, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(240.6, 0.9, 5, 0.23), 2U);  // a multiple of a tone that is not of the mains
}

TEST(ToneModes, RemovesARemainderNearATone) {
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23, {{.freq_Hz = 449.9}}), 1U);
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23, {{.freq_Hz = 455}}), 2U);
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23, {{.freq_Hz = 455, .wanders = true}}), 1U);
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0, {{.freq_Hz = 455, .wanders = true}}), 2U);
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23, {{.freq_Hz = 510, .wanders = true}}), 2U);
}

// Two hits with independent phases often have a high coherence, and a low coherence of two hits proves little.
TEST(ToneModes, NeedsThreeHits) {
  EXPECT_EQ(modes_left(449.8, 0.9, 2, 0.4), 2U);
  EXPECT_EQ(modes_left(449.8, 0.9, 3, 0.4), 1U);
}

}  // namespace percuss::pipeline::tone_modes_test
