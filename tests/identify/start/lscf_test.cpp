#include "identify/start/lscf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/modal_frfs.hpp"
#include "synth/synthesise.hpp"

namespace percuss::identify::lscf_test {

Complex root_of(const Pole& pole) {
  return {-pole.damping_ratio * pole.freq_Hz, pole.freq_Hz * std::sqrt(1 - pole.damping_ratio * pole.damping_ratio)};
}

// Distance from the truth to the nearest pole of this order, in bandwidths.
double error_of(const LscfOrder& order, const Pole& truth) {
  double nearest = 1e9;
  for (const Pole& pole : order.poles) nearest = std::min(nearest, std::abs(root_of(pole) - root_of(truth)));
  return nearest / truth.half_power_Hz();
}

FrfDataset set_of(const std::vector<Pole>& modes, double low_Hz, double high_Hz) {
  FrfDataset set = test::empty_set(12800, 16384, low_Hz, high_Hz, 2);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    test::add_mode(set, 0, modes[m], std::pow(0.7, m));
    test::add_mode(set, 1, modes[m], m % 2 == 0 ? 0.4 : -0.3);
  }
  return set;
}

const std::vector<Pole> kThree{{169.03, 0.01}, {575.4, 0.006}, {1190.06, 0.004}};
constexpr double kExact = 1e-6;  // bandwidths; rounding in sums of squares

TEST(LscfPoles, AreExactOnNoiseFreeDataWithoutSpuriousPoles) {
  const auto orders = lscf_poles(set_of(kThree, 60, 1500));
  ASSERT_EQ(orders.size(), 39U);
  EXPECT_EQ(orders.front().order, 2U);
  EXPECT_EQ(orders.back().order, 40U);
  EXPECT_EQ(orders.back().poles.size(), 3U);
  for (const Pole& mode : kThree) EXPECT_LE(error_of(orders.back(), mode), kExact) << mode.freq_Hz;
}

TEST(LscfPoles, SeparateTwoModesTwoHertzApartWhateverTheSamplingRate) {
  const std::vector<Pole> truth{{170, 0.002}, {172, 0.002}};
  for (const double fs_Hz : {1600.0, 12800.0, 102400.0}) {
    FrfDataset set = test::empty_set(fs_Hz, static_cast<std::size_t>(2.56 * fs_Hz), 60, 400, 1);
    for (const Pole& mode : truth) test::add_mode(set, 0, mode, 0.8);
    for (const Pole& mode : truth) EXPECT_LE(error_of(lscf_poles(set).back(), mode), kExact) << fs_Hz;
  }
}

TEST(LscfPoles, SeparateModesCloserThanABandwidth) {
  const std::vector<Pole> truth{{180, 0.01}, {1900, 0.003}, {1900 + 0.6 * 11.4, 0.003}, {2650, 0.004}};
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    FrfDataset set = set_of(truth, 60, 3200);
    test::add_frf_noise(set, 0.01, seed);  // the close pair has a peak of 155 in one FRF, of 54 in the other
    for (const Pole& mode : truth) EXPECT_LE(error_of(lscf_poles(set).back(), mode), 0.1) << mode.freq_Hz;
  }
}

TEST(LscfPoles, AreExactOnTruncatedAndOnWindowedRecords) {
  // The truncation term has the same poles, but it is divided by the force's spectrum, which is no polynomial. The
  // window's decay is subtracted.
  constexpr double kForce = 1e-4;  // bandwidths
  const Pole mode{200.3, 0.002};
  const auto made =
      synth::synthesise(test::bat_spec({{.freq_Hz = 200.3, .damping_ratio = 0.002, .residue_per_kg = {0.9, 0.5}},
                                        {.freq_Hz = 640, .damping_ratio = 0.004, .residue_per_kg = {0.4, 0.5}}},
                                       0.5));
  for (const double decay_per_s : {0.0, 9.2}) {
    const auto orders = lscf_poles(test::frf_set_of(made.record, 60, 1000, decay_per_s));
    EXPECT_LE(error_of(orders.back(), mode), kForce) << decay_per_s;
  }
}

TEST(LscfPoles, AreLimitedToTheGivenLines) {
  const FrfDataset set = set_of(kThree, 60, 1500);
  const auto line = [&](double freq_Hz) {
    return static_cast<std::size_t>(freq_Hz / set.lines.df_Hz()) - set.lines.first;
  };
  const auto orders = lscf_poles(set, {.max_order = 20, .first = line(400), .count = line(800) - line(400)});
  ASSERT_EQ(orders.back().order, 20U);
  EXPECT_LE(error_of(orders.back(), kThree[1]), kExact);
  for (const Pole& pole : orders.back().poles) EXPECT_TRUE(pole.freq_Hz >= 399 && pole.freq_Hz <= 801) << pole.freq_Hz;
}

TEST(LscfPoles, DoNotDependOnUnitsOrTheOrderOfFrfs) {
  constexpr double kRounding = 1e-5;  // bandwidths, for the modes; poles of the noise are less well determined
  FrfDataset set = set_of(kThree, 60, 1500);
  test::add_frf_noise(set, 0.05, 3);
  const auto a = lscf_poles(set).back();
  for (Complex& line : set.channels[0].frf) line *= -9.80665e-3;  // only this channel: each is weighted by its noise
  std::swap(set.channels[0], set.channels[1]);
  const auto b = lscf_poles(set).back();
  for (const Pole& mode : kThree) {
    const auto nearest = std::min_element(a.poles.begin(), a.poles.end(), [&](const Pole& x, const Pole& y) {
      return std::abs(root_of(x) - root_of(mode)) < std::abs(root_of(y) - root_of(mode));
    });
    ASSERT_NE(nearest, a.poles.end());
    EXPECT_LE(error_of(b, *nearest), kRounding);
  }
}

TEST(LscfPoles, AreUnaffectedByADeadChannel) {
  FrfDataset set = set_of(kThree, 60, 1500);
  std::fill(set.channels[1].frf.begin(), set.channels[1].frf.end(), Complex());
  for (const Pole& mode : kThree) EXPECT_LE(error_of(lscf_poles(set).back(), mode), kExact);
  std::fill(set.channels[0].frf.begin(), set.channels[0].frf.end(), Complex());
  EXPECT_TRUE(lscf_poles(set).empty());
}

TEST(LscfPoles, HaveAtMostOneOrderPerFourLines) {
  EXPECT_TRUE(lscf_poles(set_of(kThree, 166, 171)).empty());          // 6 lines
  EXPECT_EQ(lscf_poles(set_of(kThree, 150, 190)).back().order, 13U);  // 52 lines
  EXPECT_TRUE(lscf_poles(set_of(kThree, 60, 1500), {.first = 1u << 20U}).empty());
  const auto high = lscf_poles(set_of(kThree, 60, 1500), {.max_order = 1000});
  EXPECT_EQ(high.back().order, 100U);
  for (const Pole& mode : kThree) EXPECT_LE(error_of(high.back(), mode), kExact) << mode.freq_Hz;
}

}  // namespace percuss::identify::lscf_test
