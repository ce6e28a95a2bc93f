#include "pipeline/stages/mains_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/hits_with_phases.hpp"

namespace percuss::pipeline::mains_modes_test {

const std::vector<Tone> kHum = {{.freq_Hz = 49.99}, {.freq_Hz = 120.3}};

std::size_t modes_left(double freq_Hz, double half_power_Hz, std::size_t hits, double turns) {
  const test::HitsWithPhases test(test::mode_at(freq_Hz, half_power_Hz, 1), hits, turns);
  std::vector<identify::Mode> modes = {test.strong, test.weak_mean};
  std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.pole.freq_Hz < b.pole.freq_Hz; });
  remove_mains_modes(modes, kHum, test.set, test.frfs);
  return modes.size();
}

// 0.23 turns from hit to hit leave 0.14 of the residue in the mean of five hits, and a coherence of 0.02. The flank of
// the strong mode follows the force at every line.
TEST(MainsModes, RemovesANarrowHarmonicWhoseResiduesDoNotFollowTheForce) {
  EXPECT_EQ(modes_left(449.8, 0.9, 5, 0.23), 1U);
}

TEST(MainsModes, KeepsWhatFollowsTheForce) { EXPECT_EQ(modes_left(449.8, 0.9, 5, 0), 2U); }

TEST(MainsModes, KeepsModesBesideHarmonicsAndBroadModes) {
  EXPECT_EQ(modes_left(461, 0.9, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(449.8, 3, 5, 0.23), 2U);
  EXPECT_EQ(modes_left(240.6, 0.9, 5, 0.23), 2U);  // a multiple of a tone that is not of the mains
}

// Two hits with independent phases often have a high coherence, and a low coherence of two hits proves little.
TEST(MainsModes, NeedsThreeHits) {
  EXPECT_EQ(modes_left(449.8, 0.9, 2, 0.4), 2U);
  EXPECT_EQ(modes_left(449.8, 0.9, 3, 0.4), 1U);
}

}  // namespace percuss::pipeline::mains_modes_test
