#include "pipeline/channels/mass_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.hpp"

namespace percuss::pipeline::mass_loading_test {

// A mode along a beam of 15 points. A sensor of this mass (kg) at each point in turn lowers its frequency.
identify::Mode mode_with(double freq_Hz, int half_waves, double mass_kg, double scatter, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  identify::Mode mode{.pole = {freq_Hz, 0.01}};
  for (std::size_t point = 0; point < 15; ++point) {
    const double shape = 2 * std::sin(kTwoPi / 2 * half_waves * (static_cast<double>(point) + 0.6) / 15);
    const double freq = freq_Hz * (1 - 0.5 * mass_kg * shape * shape + scatter * normal(random));
    mode.residues.push_back({.point = point, .value = 1.3 * shape, .own_pole = identify::Pole{freq, 0.01}});
  }
  return mode;
}

TEST(MassLoading, IsSeenWhereTheFrequencyFallsWithTheMotion) {
  const auto found = mass_loading({mode_with(200, 1, 0.005, 2e-4, 1), mode_with(500, 2, 0.005, 2e-4, 2)});
  ASSERT_EQ(found.size(), 2U);
  for (const MassLoading& one : found) {
    EXPECT_NEAR(one.largest_fall, 0.5 * 0.005 * 4, 6 * one.std);
    EXPECT_EQ(one.points, 15U);
  }
}

TEST(MassLoading, IsNotSeenInScatterOrWhereFrequenciesRise) {
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    EXPECT_TRUE(mass_loading({mode_with(200, 1, 0, 1e-3, seed), mode_with(500, 2, 0, 1e-3, seed + 100)}).empty());
  EXPECT_TRUE(mass_loading({mode_with(200, 1, 0.005, 2e-4, 1), mode_with(500, 2, -0.005, 2e-4, 2)}).empty());
}

// If a sensor's mass moves two close modes across each other, one of them can seem to rise.
TEST(MassLoading, IsSeenAlthoughOneOfManyFrequenciesRises) {
  std::vector<identify::Mode> modes{mode_with(100, 1, -0.005, 2e-4, 1)};
  for (std::uint64_t seed = 2; seed < 6; ++seed)
    modes.push_back(mode_with(100 * static_cast<double>(seed), 2, 0.005, 2e-4, seed));
  EXPECT_TRUE(mass_loading(modes).empty()) << "four fall";
  modes.push_back(mode_with(600, 3, 0.005, 2e-4, 6));
  const auto found = mass_loading(modes);
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found.front().mode, 1U);
}

}  // namespace percuss::pipeline::mass_loading_test
