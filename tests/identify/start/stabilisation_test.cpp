#include "identify/start/stabilisation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::stabilisation_test {

const std::vector<identify::Pole> kModes{{169.03, 0.01}, {575.4, 0.006}, {1190.06, 0.004}, {1195.8, 0.004}};

identify::FrfDataset set_of(double noise, std::uint64_t seed = 1) {
  identify::FrfDataset set = test::empty_set(4096, 8192, 60, 1500, 2);
  for (std::size_t m = 0; m < kModes.size(); ++m) {
    test::add_mode(set, 0, kModes[m], 0.8);
    test::add_mode(set, 1, kModes[m], m % 2 == 0 ? 0.5 : -0.3);
  }
  if (noise > 0) test::add_frf_noise(set, noise, seed);
  return set;
}

// A diagram drawn by hand: one pole per order from 2 up.
identify::Stabilisation column(std::size_t orders, double freq_Hz, double damping_ratio) {
  identify::Stabilisation diagram;
  for (std::size_t order = 2; order < 2 + orders; ++order) {
    diagram.poles.push_back({.order = order,
                             .pole = {.freq_Hz = freq_Hz, .damping_ratio = damping_ratio},
                             .stability = order == 2 ? identify::Stability::fresh : identify::Stability::stable});
  }
  return diagram;
}

TEST(Stabilise, MarksAPoleNewAtItsFirstOrderAndStableAfterwards) {
  const identify::Stabilisation diagram = identify::stabilise(set_of(0));
  EXPECT_NEAR(diagram.low_Hz, 60, 0.5);  // a line
  EXPECT_NEAR(diagram.high_Hz, 1500, 0.5);
  for (const identify::Pole& mode : kModes) {
    bool seen = false;
    for (const identify::StabilisationPole& pole : diagram.poles) {
      if (std::abs(pole.pole.freq_Hz - mode.freq_Hz) > 0.1 * mode.half_power_Hz()) continue;
      if (!seen) {
        EXPECT_NE(pole.stability, identify::Stability::stable) << mode.freq_Hz;
      }
      seen = true;
      if (pole.order == 40) {
        EXPECT_EQ(pole.stability, identify::Stability::stable) << mode.freq_Hz;
      }
    }
    EXPECT_TRUE(seen) << mode.freq_Hz;
  }
}

TEST(Stabilise, SortsPolesByOrderThenFrequency) {
  const auto poles = identify::stabilise(set_of(0.05)).poles;
  EXPECT_TRUE(std::is_sorted(poles.begin(), poles.end(), [](const auto& a, const auto& b) {
    return a.order != b.order ? a.order < b.order : a.pole.freq_Hz < b.pole.freq_Hz;
  }));
}

TEST(Stabilise, HasNamesForItsStates) {
  EXPECT_STREQ(name_of(identify::Stability::fresh), "new");
  EXPECT_STREQ(name_of(identify::Stability::frequency), "frequency");
  EXPECT_STREQ(name_of(identify::Stability::damping), "damping");
  EXPECT_STREQ(name_of(identify::Stability::stable), "stable");
}

TEST(Stabilise, OfNoLinesIsEmpty) {
  EXPECT_TRUE(identify::stabilise({}).poles.empty());
  EXPECT_TRUE(identify::stabilised_candidates({}).empty());
}

TEST(ClusterPoles, GroupPolesThatStayOverTheOrders) {
  const auto clusters = identify::cluster_poles(column(10, 500, 0.01));
  ASSERT_EQ(clusters.size(), 1U);
  EXPECT_EQ(clusters[0].stable, 9U);
  EXPECT_EQ(clusters[0].pole.freq_Hz, 500);
  EXPECT_EQ(clusters[0].pole.damping_ratio, 0.01);
  EXPECT_EQ(clusters[0].freq_spread_Hz, 0);
  EXPECT_EQ(clusters[0].damping_spread, 0);
}

TEST(ClusterPoles, OmitIntermittentPoles) { EXPECT_TRUE(identify::cluster_poles(column(5, 500, 0.01)).empty()); }

TEST(ClusterPoles, TakeOnePolePerOrder) {
  identify::Stabilisation diagram = column(10, 500, 0.01);
  const identify::Stabilisation beside = column(10, 502, 0.01);  // a fifth of a bandwidth
  diagram.poles.insert(diagram.poles.end(), beside.poles.begin(), beside.poles.end());
  std::stable_sort(diagram.poles.begin(), diagram.poles.end(),
                   [](const auto& a, const auto& b) { return a.order < b.order; });
  const auto clusters = identify::cluster_poles(diagram);
  ASSERT_EQ(clusters.size(), 2U);
  EXPECT_EQ(clusters[0].pole.freq_Hz, 500);
  EXPECT_EQ(clusters[1].pole.freq_Hz, 502);
}

TEST(ClusterPoles, AreTheModesOfNoiseFreeLines) {
  const auto clusters = identify::cluster_poles(identify::stabilise(set_of(0)));
  ASSERT_EQ(clusters.size(), kModes.size());
  constexpr double kExact = 1e-5;  // bandwidths; medians over all orders
  for (std::size_t m = 0; m < kModes.size(); ++m)
    EXPECT_LE(std::abs(clusters[m].pole.freq_Hz - kModes[m].freq_Hz), kExact * kModes[m].half_power_Hz());
}

TEST(StabilisedCandidates, AreNearEveryModeAlsoOfAClosePair) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto poles = identify::stabilised_candidates(set_of(0.05, seed));
    for (const identify::Pole& mode : kModes) {
      const auto near = [&](const identify::Pole& pole) {
        return std::abs(pole.freq_Hz - mode.freq_Hz) <= 0.2 * mode.half_power_Hz();  // a start for a fit
      };
      EXPECT_EQ(std::count_if(poles.begin(), poles.end(), near), 1) << mode.freq_Hz << " seed " << seed;
    }
  }
}

}  // namespace percuss::identify::stabilisation_test
