#include "identify/start/stable_poles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/modal_frfs.hpp"

namespace percuss::identify::stable_poles_test {

// Thirty modes with an overlap (bandwidth over spacing) of one half, and one with a damping ratio of 15 %.
std::vector<Pole> overlapping_modes() {
  std::vector<Pole> modes{{.freq_Hz = 150, .damping_ratio = 0.15}};
  for (int i = 0; i < 30; ++i) {
    const double freq_Hz = 500 + 30.0 * i + 4.0 * (i % 3);
    modes.push_back({.freq_Hz = freq_Hz, .damping_ratio = 7.5 / freq_Hz});
  }
  return modes;
}

TEST(StablePoles, HoldThirtyOverlappingModesAndABroadOne) {
  FrfDataset set = test::empty_set(8192, 8192, 60, 1500, 2);
  const std::vector<Pole> modes = overlapping_modes();
  for (std::size_t m = 0; m < modes.size(); ++m) {
    test::add_mode(set, 0, modes[m], 0.8);
    test::add_mode(set, 1, modes[m], m % 2 == 0 ? 0.5 : -0.3);
  }
  test::add_frf_noise(set, 1e-3, 1);
  const std::vector<Pole> found = stable_poles(set);
  for (const Pole& mode : modes) {
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Pole& pole) { return same_place(pole, mode); }))
        << mode.freq_Hz;
  }
  EXPECT_LT(found.size(), 2 * modes.size());
}

TEST(StablePoles, OfNoLinesAreNone) { EXPECT_TRUE(stable_poles({}).empty()); }

}  // namespace percuss::identify::stable_poles_test
