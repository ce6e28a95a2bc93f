#include "pipeline/stages/narrow_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/hits_with_phases.hpp"

namespace percuss::pipeline::narrow_bands_test {

constexpr double kWeak_Hz = 620.4;

// The modes after a search at the weak mode, when only the strong mode is known. The phase of the weak mode advances by
// `turns` from hit to hit.
std::vector<identify::Mode> modes_after_search(std::size_t hits, double turns, double half_power_Hz = 2) {
  const test::HitsWithPhases test(test::mode_at(kWeak_Hz, half_power_Hz, 1), hits, turns);
  std::vector<identify::Mode> modes = {test.strong};
  add_modes_at({{620}}, modes, test.set, test.frfs, identify::Effort::best);
  return modes;
}

TEST(NarrowBands, AddAModeThatFollowsTheForce) {
  const auto modes = modes_after_search(5, 0);
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_NEAR(modes[1].pole.freq_Hz, kWeak_Hz, 5 * modes[1].freq_std_Hz);
  EXPECT_LT(modes[1].freq_std_Hz, 0.01);  // half a percent of the half-power bandwidth
}

// 0.23 turns from hit to hit leave 0.14 of the residue in the mean, far above the noise.
TEST(NarrowBands, AddNoModeWhosePhaseChangesFromHitToHit) { EXPECT_EQ(modes_after_search(5, 0.23).size(), 1U); }

// With one or two hits, phases cannot show that a resonance is no tone, but its end within the record can.
TEST(NarrowBands, AddAModeOfFewHitsThatDiesOut) {
  for (const std::size_t hits : {1U, 2U}) EXPECT_EQ(modes_after_search(hits, 0, 2).size(), 2U) << hits;
}

// 0.02 Hz wide: 0.94 of the amplitude is left after the record of 1 s.
TEST(NarrowBands, AddNoSteadyToneOfFewHits) {
  for (const std::size_t hits : {1U, 2U}) EXPECT_EQ(modes_after_search(hits, 0, 0.02).size(), 1U) << hits;
}

// The coherence of two residues that are 0.23 turns apart is cos²(0.23 π) = 0.56.
TEST(NarrowBands, AddNoModeThatTwoHitsDeny) { EXPECT_EQ(modes_after_search(2, 0.23, 2).size(), 1U); }

TEST(NarrowBands, KeepAllModesThatAreKnown) {
  const test::HitsWithPhases test(test::mode_at(kWeak_Hz, 2, 1), 5, 0.23);
  std::vector<identify::Mode> modes = {test.strong, test.weak_mean};
  add_modes_at({{800}}, modes, test.set, test.frfs, identify::Effort::best);
  EXPECT_EQ(modes.size(), 2U);
}

}  // namespace percuss::pipeline::narrow_bands_test
