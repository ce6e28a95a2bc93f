#include "metrics/deflection/impact_onset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "metrics/deflection/deflection.hpp"

namespace percuss::metrics::impact_onset_test {

constexpr double kFs_Hz = 25600, kContact_s = 0.002;

// A contact force sin^p: it begins as t^p.
std::vector<double> pulse(double onset_s, double power, double noise, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  std::vector<double> x(1024);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kFs_Hz - onset_s;
    x[n] = (t > 0 && t < kContact_s ? 500 * std::pow(std::sin(std::numbers::pi * t / kContact_s), power) : 0) +
           noise * gauss(random);
  }
  return x;
}

ImpactOnset onset_in(const std::vector<double>& x, double noise) {
  const auto first = static_cast<std::size_t>(std::lround(motion_onset_s(x, kFs_Hz) * kFs_Hz));
  return impact_onset(x, kFs_Hz, first, noise);
}

TEST(ImpactOnset, LiesBetweenTheSamples) {
  std::mt19937 random(1);
  for (const double power : {1.0, 1.25, 1.5}) {
    double sum = 0, squares = 0, stated = 0;
    constexpr int kTrials = 200;
    for (int trial = 0; trial < kTrials; ++trial) {
      const double onset_s = 0.01 + static_cast<double>(trial) / kTrials / kFs_Hz;
      const ImpactOnset found = onset_in(pulse(onset_s, power, 0.2, random), 0.2);
      const double z = (found.time_s - onset_s) / found.std_s;
      sum += z;
      squares += z * z;
      stated += found.std_s * kFs_Hz / kTrials;
    }
    EXPECT_LE(std::abs(sum / kTrials), 1.1) << power;  // one standard deviation for the powers 1 and 3/2
    EXPECT_LE(std::sqrt(squares / kTrials), 1.3) << power;
    EXPECT_LE(stated, 0.75) << power;  // samples
    if (power == 1.25) {
      EXPECT_LE(std::abs(sum / kTrials), 0.35);
    }
  }
}

TEST(ImpactOnset, IsAnywhereBetweenTwoSamplesOfASteepRise) {
  std::vector<double> x(200);
  for (std::size_t n = 100; n < 110; ++n) x[n] = n == 100 ? 5 : 1;
  const ImpactOnset found = impact_onset(x, kFs_Hz, 100, 0.01);
  EXPECT_NEAR(found.time_s * kFs_Hz, 99.5, 0.5);
  EXPECT_GE(found.std_s * kFs_Hz, 0.2);
}

}  // namespace percuss::metrics::impact_onset_test
