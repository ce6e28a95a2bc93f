#include "metrics/deflection/impact_onset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "metrics/deflection/deflection.hpp"

namespace percuss::metrics::impact_onset_test {

constexpr double kFs_Hz = 25600, kTop = 500;

// A contact force sin^p: it begins as t^p.
std::vector<double> pulse(double onset_s, double contact_s, double power, double noise, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  std::vector<double> x(1024);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double t = static_cast<double>(n) / kFs_Hz - onset_s;
    x[n] = (t > 0 && t < contact_s ? kTop * std::pow(std::sin(std::numbers::pi * t / contact_s), power) : 0) +
           noise * gauss(random);
  }
  return x;
}

ImpactOnset onset_in(const std::vector<double>& x, double noise) {
  const auto first = static_cast<std::size_t>(std::lround(motion_onset_s(x, kFs_Hz) * kFs_Hz));
  return impact_onset(x, kFs_Hz, first, noise);
}

// Errors in standard deviations, and the standard deviation in samples.
struct Statistics {
  double mean = 0, root_mean_square = 0, stated_samples = 0;
};
Statistics statistics_of(double contact_s, double power, double noise) {
  std::mt19937 random(1);
  Statistics out;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double onset_s = 0.01 + static_cast<double>(trial) / kTrials / kFs_Hz;
    const ImpactOnset found = onset_in(pulse(onset_s, contact_s, power, noise, random), noise);
    const double z = (found.time_s - onset_s) / found.std_s;
    out.mean += z / kTrials;
    out.root_mean_square += z * z / kTrials;
    out.stated_samples += found.std_s * kFs_Hz / kTrials;
  }
  out.root_mean_square = std::sqrt(out.root_mean_square);
  return out;
}

// From a half-sine to a haversine.
TEST(ImpactOnset, LiesBetweenTheSamples) {
  for (const double contact_s : {0.0007, 0.002}) {
    for (const double noise : {0.2, 2.0, 10.0}) {
      for (const double power : {1.0, 1.25, 1.5, 1.75, 2.0}) {
        SCOPED_TRACE(testing::Message() << contact_s << " s, noise " << noise << ", power " << power);
        const Statistics found = statistics_of(contact_s, power, noise);
        EXPECT_LE(std::abs(found.mean), 0.8);  // the power is not known
        EXPECT_LE(found.root_mean_square, 1.4);
        EXPECT_LE(found.stated_samples, noise < 1 ? 0.15 : 1.5);
      }
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
