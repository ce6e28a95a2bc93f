#include "identify/misfit/unresolved_partners.hpp"

#include <gtest/gtest.h>

#include "support/modal_frfs.hpp"

namespace percuss::identify::unresolved_partners_test {

// Two modes away from 800 Hz.
FrfDataset other_modes() {
  FrfDataset set = test::empty_set(4096, 2048, 300, 1500, 1);
  for (const double freq_Hz : {500.0, 1200.0}) test::add_mode(set, 0, {freq_Hz, 0.004}, 1);
  return set;
}

// The free decay of a mode whose frequency rises with the square of its amplitude: while the amplitude falls as
// exp(−a t), the phase leads by c (1 − exp(−2 a t)). Expanded in powers of c, it is a sum of exponential decays at
// one frequency with the damping ratios ζ, 3 ζ, 5 ζ …
void add_mode_of_changing_frequency(FrfDataset& set, const Pole& pole, double change_rad) {
  Complex residue = 1;
  for (int k = 0; k < 12; ++k) {
    test::add_mode(set, 0, {.freq_Hz = pole.freq_Hz, .damping_ratio = pole.damping_ratio * (2 * k + 1)}, residue);
    residue *= Complex(0, -change_rad) / static_cast<double>(k + 1);
  }
}

TEST(UnresolvedPartners, OfAModeWhoseFrequencyChangesAreDropped) {
  const Pole pole{.freq_Hz = 800.3, .damping_ratio = 0.0006};
  FrfDataset set = other_modes();
  add_mode_of_changing_frequency(set, pole, 2);
  test::add_frf_noise(set, 0.01, 7);
  const std::vector<FittedMode> found = fit_sequentially(set);
  ASSERT_GT(found.size(), 3U);
  const std::vector<FittedMode> modes = without_unresolved_partners(set, found, {});
  ASSERT_EQ(modes.size(), 3U);
  EXPECT_NEAR(modes[1].mode.pole.freq_Hz, pole.freq_Hz, 2 * pole.half_power_Hz());  // the change of the frequency
}

TEST(UnresolvedPartners, KeepsAPairThatTheFrfsShow) {
  const Pole a{.freq_Hz = 800.3, .damping_ratio = 0.002}, b{.freq_Hz = 801.9, .damping_ratio = 0.0025};
  for (const double noise : {0.01, 0.1, 0.3}) {
    FrfDataset set = other_modes();
    test::add_mode(set, 0, a, 1);
    test::add_mode(set, 0, b, 0.7);
    test::add_frf_noise(set, noise, 7);
    const std::vector<FittedMode> found = fit_sequentially(set);
    ASSERT_EQ(found.size(), 4U) << noise;
    const std::vector<FittedMode> modes = without_unresolved_partners(set, found, {});
    ASSERT_EQ(modes.size(), 4U) << noise;
    for (std::size_t m = 0; m < 4; ++m) EXPECT_EQ(modes[m].mode.pole, found[m].mode.pole) << noise;
  }
}

}  // namespace percuss::identify::unresolved_partners_test
