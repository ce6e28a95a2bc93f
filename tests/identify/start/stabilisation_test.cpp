#include "identify/start/stabilisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::stabilisation_test {

const std::vector<Pole> kModes{{169.03, 0.01}, {575.4, 0.006}, {1190.06, 0.004}, {1195.8, 0.004}};

FrfDataset set_of(double noise) {
  FrfDataset set = test::empty_set(4096, 8192, 60, 1500, 2);
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    test::add_mode(set, 0, kModes[m], 0.8);
    test::add_mode(set, 1, kModes[m], m % 2 == 0 ? 0.5 : -0.3);
  }
  if (noise > 0) test::add_frf_noise(set, noise, 1);
  return set;
}

TEST(Stabilise, MarksAPoleStableOnlyAfterItsFirstOrder) {
  const Stabilisation diagram = stabilise(set_of(0));
  EXPECT_NEAR(diagram.low_Hz, 60, 0.5);  // within one spectral line
  EXPECT_NEAR(diagram.high_Hz, 1500, 0.5);
  for (const Pole& mode : kModes) {
    bool seen = false, at_last = false;
    for (const StabilisationPole& pole : diagram.poles) {
      if (std::abs(pole.pole.freq_Hz - mode.freq_Hz) > 0.1 * mode.half_power_Hz()) continue;
      if (!seen) {
        EXPECT_NE(pole.stability, Stability::stable) << mode.freq_Hz;
      }
      seen = true;
      if (pole.order == 40) {
        at_last = true;
        EXPECT_EQ(pole.stability, Stability::stable) << mode.freq_Hz;
      }
    }
    EXPECT_TRUE(seen) << mode.freq_Hz;
    EXPECT_TRUE(at_last) << mode.freq_Hz;
  }
}

TEST(Stabilise, SortsPolesByOrderThenFrequency) {
  const auto poles = stabilise(set_of(0.05)).poles;
  EXPECT_TRUE(std::is_sorted(poles.begin(), poles.end(), [](const auto& a, const auto& b) {
    return a.order != b.order ? a.order < b.order : a.pole.freq_Hz < b.pole.freq_Hz;
  }));
}

TEST(Stabilise, HasNamesForItsStates) {
  EXPECT_STREQ(name_of(Stability::fresh), "new");
  EXPECT_STREQ(name_of(Stability::frequency), "frequency");
  EXPECT_STREQ(name_of(Stability::damping), "damping");
  EXPECT_STREQ(name_of(Stability::stable), "stable");
}

TEST(Stabilise, OfNoLinesIsEmpty) { EXPECT_TRUE(stabilise({}).poles.empty()); }

}  // namespace percuss::identify::stabilisation_test
