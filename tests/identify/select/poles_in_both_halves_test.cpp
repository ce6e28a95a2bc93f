#include "identify/select/poles_in_both_halves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/modal_frfs.hpp"

namespace percuss::identify::poles_in_both_halves_test {

constexpr std::size_t kPoints = 10;
constexpr double kNoise = 1e-3;  // the peaks are 50 and 100 times the shape

// Points of one channel each, with the force unknown.
FrfDataset points() {
  FrfDataset set = test::empty_set(4096, 8192, 100, 500, kPoints);
  set.points.resize(kPoints);
  for (std::size_t o = 0; o < kPoints; ++o) set.channels[o] = {.point = o, .channel = 0, .frf = set.channels[o].frf};
  return set;
}

double shape(std::size_t point, double half_waves) {
  return std::cos(half_waves * std::numbers::pi * (static_cast<double>(point) + 0.3) / static_cast<double>(kPoints));
}

TEST(PolesInBothHalves, HoldACloseDoublet) {
  FrfDataset set = points();
  const std::vector<Pole> poles{{200, 0.01}, {203, 0.01}, {350, 0.005}};
  for (std::size_t o = 0; o < kPoints; ++o) {
    for (std::size_t m = 0; m < poles.size(); ++m)
      test::add_mode(set, o, poles[m], shape(o, 1 + static_cast<double>(m)));
  }
  test::add_frf_noise(set, kNoise, 1);
  EXPECT_EQ(poles_in_both_halves(set, poles).size(), poles.size());
}

// The resonance lies at 200.3 Hz at the points of one half and at 202.9 Hz at those of the other.
TEST(PolesInBothHalves, LeaveOutAPoleThatTheHalvesPlaceElsewhere) {
  FrfDataset set = points();
  for (std::size_t o = 0; o < kPoints; ++o) {
    test::add_mode(set, o, {o % 2 == 0 ? 200.3 : 202.9, 0.01}, shape(o, 1));
    test::add_mode(set, o, {350, 0.005}, shape(o, 2));
  }
  test::add_frf_noise(set, kNoise, 2);
  const std::vector<Pole> kept = poles_in_both_halves(set, {{201.6, 0.01}, {350, 0.005}});
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].freq_Hz, 350);
}

// As on a grid of odd length, where a mode moves the corners and not the points between.
TEST(PolesInBothHalves, HoldAModeThatEverySecondPointHardlyShows) {
  FrfDataset set = points();
  const std::vector<Pole> poles{{200, 0.01}, {350, 0.005}};
  for (std::size_t o = 0; o < kPoints; ++o) {
    if (o % 2 == 0) test::add_mode(set, o, poles[0], shape(o, 1));
    test::add_mode(set, o, poles[1], shape(o, 2));
  }
  test::add_frf_noise(set, kNoise, 3);
  EXPECT_EQ(poles_in_both_halves(set, poles).size(), poles.size());
}

}  // namespace percuss::identify::poles_in_both_halves_test
