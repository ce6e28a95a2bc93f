#include "identify/start/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/modal_frfs.hpp"

namespace percuss::identify::candidates_test {

FrfDataset three_modes() {
  FrfDataset set = test::empty_set(4096, 32768, 60, 1500, 2);
  for (const Pole& pole : {Pole{169.03, 0.01}, Pole{575.4, 0.006}, Pole{1190.06, 0.004}}) {
    test::add_mode(set, 0, pole, 0.8);
    test::add_mode(set, 1, pole, -0.3);
  }
  return set;
}

TEST(CandidatePoles, AreNearTheModesWithAPeak) {
  const FrfDataset set = three_modes();
  const auto poles = candidate_poles(set, LineNoise(set));
  ASSERT_EQ(poles.size(), 3U);
  const std::vector<Pole> truth{{169.03, 0.01}, {575.4, 0.006}, {1190.06, 0.004}};
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_LE(std::abs(poles[m].freq_Hz - truth[m].freq_Hz), 0.25 * truth[m].half_power_Hz());  // a start for the fit
    EXPECT_LE(std::abs(poles[m].damping_ratio / truth[m].damping_ratio - 1), 0.3);
  }
}

TEST(CandidatePoles, AreNotQuantisedToALine) {
  const FrfDataset set = three_modes();
  const auto poles = candidate_poles(set, LineNoise(set));
  ASSERT_EQ(poles.size(), 3U);
  for (const Pole& pole : poles) {
    const double lines = pole.freq_Hz / set.lines.df_Hz();
    EXPECT_GE(std::abs(lines - std::round(lines)), 1e-6);
  }
}

// A fit of one resonance finds the same pole around either peak. The peak that is farther from this pole gets a pole at
// its own line.
TEST(CandidatePoles, BelongToTheirOwnPeaks) {
  FrfDataset set = test::empty_set(4096, 2048, 300, 1500, 1);
  test::add_mode(set, 0, {800.3, 0.0003}, 1);
  test::add_mode(set, 0, {804.3, 0.0003}, 0.9);
  test::add_frf_noise(set, 0.01, 7);
  const auto poles = candidate_poles(set, LineNoise(set));
  ASSERT_EQ(poles.size(), 2U);
  EXPECT_NEAR(poles[0].freq_Hz, 800, 0.5 * set.lines.df_Hz());
  EXPECT_GE(poles[1].freq_Hz - poles[0].freq_Hz, set.lines.df_Hz());
}

TEST(CandidatePoles, AreAbsentFrom40SetsOfPureNoise) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    FrfDataset set = test::empty_set(4096, 32768, 60, 1500, 2);
    test::add_frf_noise(set, 1, seed);
    EXPECT_TRUE(candidate_poles(set, LineNoise(set)).empty()) << seed;
  }
}

TEST(CandidatePoles, DoNotDependOnTheUnit) {
  constexpr double kTolerance = 1e-9;  // relative; rounding
  FrfDataset set = three_modes();
  test::add_frf_noise(set, 0.05, 3);
  const auto a = candidate_poles(set, LineNoise(set));
  for (FrfChannel& channel : set.channels) {
    for (Complex& line : channel.frf) line *= -9.80665e-3;
  }
  std::swap(set.channels[0], set.channels[1]);
  const auto b = candidate_poles(set, LineNoise(set));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t m = 0; m < a.size(); ++m) EXPECT_LE(std::abs(a[m].freq_Hz / b[m].freq_Hz - 1), kTolerance);
}

TEST(CandidatePoles, NeedAFewLines) {
  FrfDataset set = test::empty_set(4096, 32768, 60, 60.4, 1);
  EXPECT_LT(set.lines.count, 5U);
  EXPECT_TRUE(candidate_poles(set, LineNoise(set)).empty());
}

TEST(ResidualModePoles, AreFoundInAResidual) {
  constexpr double kDeviation = 0.05;
  FrfDataset set = three_modes();
  test::add_frf_noise(set, kDeviation, 3);
  FrfDataset residual = test::empty_set(4096, 32768, 60, 1500, 2);
  test::add_mode(residual, 0, {800, 0.004}, 30 * 0.008 * kDeviation);  // a peak of 30 standard deviations
  test::add_frf_noise(residual, kDeviation, 4);
  const auto poles = residual_mode_poles(set, test::frf_vectors(residual));
  // Several widths show the same mode; the best one is kept. One pole lies within half the bandwidth of 6.4 Hz.
  const auto near = [](const Pole& pole) { return std::abs(pole.freq_Hz - 800) <= 0.5 * 6.4; };
  EXPECT_EQ(std::count_if(poles.begin(), poles.end(), near), 1);
}

TEST(ResidualModePoles, AreNotFoundInNoise) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    FrfDataset residual = test::empty_set(4096, 32768, 60, 1500, 2);
    test::add_frf_noise(residual, 0.3, seed);
    EXPECT_TRUE(residual_mode_poles(three_modes(), test::frf_vectors(residual)).empty()) << seed;
  }
}

TEST(ResidualModePoles, AreNotFoundInAZeroResidual) {
  const FrfDataset residual = test::empty_set(4096, 32768, 60, 1500, 2);
  EXPECT_TRUE(residual_mode_poles(three_modes(), test::frf_vectors(residual)).empty());
}

TEST(PolesNear, AreThePeaksNearTheGivenFrequencies) {
  const FrfDataset set = three_modes();
  const auto poles = poles_near(set, {574, 170});
  ASSERT_EQ(poles.size(), 2U);
  EXPECT_LE(std::abs(poles[0].freq_Hz - 575.4), 0.5);
  EXPECT_LE(std::abs(poles[1].freq_Hz - 169.03), 0.5);
}

TEST(PolesNear, StayAtTheFrequencyWithoutAPeak) {
  FrfDataset set = three_modes();
  test::add_frf_noise(set, 0.3, 8);
  const Pole pole = poles_near(set, {900}).front();
  // Twice the search range, because a pole may lie beside its line.
  EXPECT_LE(std::abs(pole.freq_Hz - 900), 2 * std::max(0.005 * 900, 4 * set.lines.df_Hz()));
  EXPECT_GT(pole.damping_ratio, 0);
  EXPECT_GT(poles_near(set, {0}).front().freq_Hz, 0);    // below the lines
  EXPECT_GT(poles_near(set, {1e6}).front().freq_Hz, 0);  // above the lines
}

TEST(PolesNear, DoNotShareAPeak) {
  const FrfDataset set = three_modes();
  for (const bool farther_first : {true, false}) {
    const auto poles = poles_near(set, farther_first ? std::vector{573.5, 575.5} : std::vector{575.5, 577.0});
    EXPECT_LE(std::abs(poles[farther_first ? 1 : 0].freq_Hz - 575.4), 0.5);
    EXPECT_EQ(poles[farther_first ? 0 : 1].freq_Hz, farther_first ? 573.5 : 577.0);
  }
}

}  // namespace percuss::identify::candidates_test
