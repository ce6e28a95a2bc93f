#include "identify/hits/drift_removal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "identify/fit/joint_fit.hpp"
#include "support/modal_frfs.hpp"
#include "support/single_hits.hpp"

namespace percuss::identify::drift_removal_test {

constexpr double kNoise = 1e-4;
constexpr double kPerHit = 2e-5;
const std::vector<Pole> kPoles{{300, 0.005}, {340, 0.004}, {343, 0.004}};

Mode drifting(double change, double std) {
  Mode mode;
  mode.drift = DriftTrend{.freq_change_per_hit = change, .std = std};
  return mode;
}

TEST(CommonDrift, IsTheMeanOfModesThatDriftAlike) {
  const auto drift = common_drift({drifting(1e-6, 1e-8), drifting(1.02e-6, 1e-8), Mode(), drifting(0.98e-6, 1e-8)});
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->freq_change_per_hit, 1e-6, 1e-12);
  EXPECT_NEAR(drift->std, 1e-8 / std::sqrt(3.0), 1e-12);
}

TEST(CommonDrift, IsNoneOfTwoModesOrOfModesThatDriftApart) {
  EXPECT_FALSE(common_drift({drifting(1e-6, 1e-8), drifting(1e-6, 1e-8)}));
  EXPECT_FALSE(common_drift({drifting(1e-6, 1e-8), drifting(2e-6, 1e-8), drifting(-1e-6, 1e-8)}));
}

// Ten points of two hits. All frequencies rise from hit to hit, in total by about 4 % of the half-power bandwidth.
TEST(WithoutDrift, LeavesTheModesOfTheMiddleOfTheTest) {
  const auto residue = [](std::size_t mode, std::size_t point) {
    return std::cos(1.3 * static_cast<double>(mode + 1) + 0.7 * static_cast<double>(point));
  };
  constexpr double kMiddle = 9.5;
  const test::SingleHits hits(10, 2, kNoise, [&](FrfDataset& one, std::size_t point, std::size_t hit) {
    const double change = kPerHit * (static_cast<double>(2 * point + hit) - kMiddle);
    for (std::size_t m = 0; m < kPoles.size(); ++m)
      test::add_mode(one, 0, {kPoles[m].freq_Hz * (1 + change), kPoles[m].damping_ratio}, residue(m, point));
  });
  const JointFit before = fit_jointly(hits.set, kPoles);
  std::vector<Mode> modes = hits.modes(before);
  SteadyTest steady;
  JointFit after;
  // Each pass reduces the error of the residues to about a tenth. After the fifth pass, it is less than the noise.
  for (int pass = 0; pass < 5; ++pass) {
    steady = without_drift(hits.set, hits.frfs, modes, kPerHit);
    after = fit_jointly(steady.set, kPoles);
    modes = hits.modes(after);
  }
  for (std::size_t m = 0; m < kPoles.size(); ++m) {
    const auto at = static_cast<Eigen::Index>(m);
    EXPECT_NEAR(after.poles[m].freq_Hz, kPoles[m].freq_Hz, 5 * after.freq_std_Hz(at)) << m;
    EXPECT_NEAR(after.poles[m].damping_ratio, kPoles[m].damping_ratio, 5 * after.damping_std(at)) << m;
    EXPECT_GT(std::abs(before.poles[m].damping_ratio - kPoles[m].damping_ratio), 20 * after.damping_std(at)) << m;
    for (std::size_t p = 0; p < 10; ++p) {
      const auto row = static_cast<Eigen::Index>(p);
      EXPECT_NEAR(std::real(after.residues(row, at)), residue(m, p), 5 * after.residue_std(row, at)) << m << ' ' << p;
    }
  }
  // The drift is also removed from the single hits: at each point, the mean of their FRFs is the FRF of the point.
  for (std::size_t p = 0; p < 10; ++p) {
    const Complex* const force = steady.hits.set.points[2 * p].spectra.front().get();
    for (std::size_t k = 0; k < steady.set.lines.count; ++k) {
      const Complex mean = 0.5 * (steady.hits.accel[2 * p][k] + steady.hits.accel[2 * p + 1][k]) / force[k];
      ASSERT_LE(std::abs(mean - steady.set.channels[p].frf[k]), 1e-9 * std::abs(mean) + 1e-12) << p << ' ' << k;
    }
  }
}

TEST(DescribeCommonDrift, WidensTheStandardDeviationToTheSpreadOfTheTest) {
  std::vector<Mode> modes(1);
  modes[0].pole = {1000, 0.01};
  modes[0].freq_std_parts_Hz.noise = modes[0].freq_std_Hz = 1e-3;
  std::vector<Mode> before = modes;
  before[0].hit_scatter_Hz = 0.2;
  describe_common_drift({.freq_change_per_hit = -1e-5, .std = 1e-7}, 11, before, modes);
  EXPECT_NEAR(modes[0].freq_std_parts_Hz.hits, 1e-2 * std::sqrt(11.0), 1e-9)
      << "of the orders 1 to 11, with the divisor n − 1: √11";
  EXPECT_NEAR(modes[0].freq_std_Hz, std::hypot(1e-3, 1e-2 * std::sqrt(11.0)), 1e-9);
  EXPECT_EQ(modes[0].drift->freq_change_per_hit, -1e-5);
  EXPECT_EQ(modes[0].hit_scatter_Hz, 0.2);
}

}  // namespace percuss::identify::drift_removal_test
