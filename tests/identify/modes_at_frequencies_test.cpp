#include "identify/modes_at_frequencies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "identify/identify.hpp"
#include "identify/start/unmodelled_peaks.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::modes_at_frequencies_test {

constexpr double kDeviations = 5;  // of a few values: one false alarm in a million
constexpr std::array<Pole, 2> kPair = {
    {{.freq_Hz = 518.1, .damping_ratio = 0.0009}, {.freq_Hz = 520.3, .damping_ratio = 0.001}}};

// A strong mode, and a pair two half-power bandwidths apart, whose residues are about a hundredth of its residue.
FrfDataset strong_mode_and_pair() {
  FrfDataset set = test::empty_set(2000, 2000, 10, 990, 1);
  test::add_mode(set, 0, {.freq_Hz = 431, .damping_ratio = 0.005}, 100);
  test::add_mode(set, 0, kPair[0], 1);
  test::add_mode(set, 0, kPair[1], 0.7);
  test::add_frf_noise(set, 0.5, 1);
  return set;
}

std::vector<Mode> strong_mode(const FrfDataset& set) {
  std::vector<Mode> modes = identify_modes(set);
  std::erase_if(modes, [](const Mode& mode) { return std::abs(mode.pole.freq_Hz - 431) > 20; });
  return modes;
}

TEST(ModesAtFrequencies, FindsAWeakPair) {
  const FrfDataset set = strong_mode_and_pair();
  const std::vector<Mode> known = strong_mode(set);
  ASSERT_EQ(known.size(), 1U);
  const auto resonances = unmodelled_resonances(set, known, unmodelled_poles(set, known));
  ASSERT_FALSE(resonances.empty());
  const auto found = modes_at_frequencies(set, known, resonances, Effort::best);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_NEAR(found[m].pole.freq_Hz, kPair[m].freq_Hz, kDeviations * found[m].freq_std_Hz);
    EXPECT_NEAR(found[m].pole.damping_ratio, kPair[m].damping_ratio, kDeviations * found[m].damping_std);
    EXPECT_LT(found[m].freq_std_Hz, 0.1 * kPair[m].half_power_Hz());
  }
}

TEST(ModesAtFrequencies, RepeatsNoModeAndInventsNone) {
  const FrfDataset set = strong_mode_and_pair();
  const std::vector<Mode> known = strong_mode(set);
  EXPECT_TRUE(modes_at_frequencies(set, known, {{431}, {700}}, Effort::best).empty());
}

TEST(ModesAtFrequencies, FindsNothingUnmodelledWhereAllModesAreKnown) {
  FrfDataset set = test::empty_set(2000, 2000, 10, 990, 1);
  test::add_mode(set, 0, {.freq_Hz = 431, .damping_ratio = 0.005}, 100);
  test::add_frf_noise(set, 0.5, 1);
  const std::vector<Mode> modes = identify_modes(set);
  EXPECT_TRUE(unmodelled_resonances(set, modes, unmodelled_poles(set, modes)).empty());
}

// A strong mode and its weak neighbour, both wide. The known mode is slightly wrong, like a single mode fitted to both.
TEST(ModesAtFrequencies, TakesABandAsWideAsTheResonanceNeeds) {
  constexpr Pole kStrong{.freq_Hz = 730, .damping_ratio = 0.0135}, kWeak{.freq_Hz = 683, .damping_ratio = 0.0095};
  FrfDataset set = test::empty_set(3000, 6000, 200, 2300, 1);  // lines 0.5 Hz apart
  test::add_mode(set, 0, kStrong, 100);
  test::add_mode(set, 0, kWeak, 10);
  test::add_frf_noise(set, 0.5, 1);
  std::vector<Mode> known = identify_modes(set);
  std::erase_if(known, [](const Mode& mode) { return std::abs(mode.pole.freq_Hz - kStrong.freq_Hz) > 20; });
  ASSERT_EQ(known.size(), 1U);
  known.front().pole.freq_Hz += 1.5;
  known.front().pole.damping_ratio *= 1.05;
  const auto resonances = unmodelled_resonances(set, known, unmodelled_poles(set, known));
  const auto weak = std::find_if(resonances.begin(), resonances.end(),
                                 [&](const auto& at) { return std::abs(at.freq_Hz - kWeak.freq_Hz) < 5; });
  ASSERT_NE(weak, resonances.end());
  EXPECT_NEAR(weak->half_power_Hz, kWeak.half_power_Hz(), 0.2 * kWeak.half_power_Hz());
  const auto found = modes_at_frequencies(set, known, {*weak}, Effort::best);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].pole.freq_Hz, kWeak.freq_Hz, kDeviations * found[0].freq_std_Hz);
  EXPECT_NEAR(found[0].pole.damping_ratio, kWeak.damping_ratio, kDeviations * found[0].damping_std);
  EXPECT_LT(found[0].freq_std_Hz, 0.1 * kWeak.half_power_Hz());
}

}  // namespace percuss::identify::modes_at_frequencies_test
