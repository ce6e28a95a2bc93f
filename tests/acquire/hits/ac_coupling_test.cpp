#include "acquire/hits/ac_coupling.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "acquire/hits/hits.hpp"
#include "support/force_row.hpp"

namespace percuss::acquire::ac_coupling_test {

constexpr double kFs_Hz = 25600, kPeak_N = 300, kNoise_N = 0.06;
// Relative: three standard deviations of the corner. The rest level is a mean over 108 samples before the pulse. Its
// standard deviation is 0.006 N, 4 % of the undershoot at a corner of 0.5 Hz.
constexpr double kTolerance = 0.12;

std::vector<double> row(double noise_N = kNoise_N) {
  std::vector<double> x(12800);
  test::add_filtered_haversine(x, 500.3, 8, kPeak_N);
  test::add_noise(x, noise_N, 3);
  return x;
}

std::vector<double> coupled_row(double corner_Hz) {
  std::vector<double> pulse(12800);
  test::add_filtered_haversine(pulse, 500.3, 8, kPeak_N);
  std::vector<double> x = test::ac_coupled(pulse, kFs_Hz / (2 * std::numbers::pi * corner_Hz));
  test::add_noise(x, kNoise_N, 3);
  return x;
}

double corner_of(const std::vector<double>& force_N) {
  const auto hits = find_hits(test::force_record(kFs_Hz, {force_N}));
  EXPECT_EQ(hits.size(), 1U);
  return hits.empty() ? -1 : hits[0].coupling_Hz;
}

TEST(AcCoupling, HasTheCornerOfTheHighPass) {
  for (const double corner_Hz : {0.5, 2.0, 5.0, 20.0})
    EXPECT_NEAR(corner_of(coupled_row(corner_Hz)) / corner_Hz, 1, kTolerance) << corner_Hz;
}

TEST(AcCoupling, IsNoneInADirectChannel) {
  EXPECT_EQ(corner_of(row()), 0);
  EXPECT_EQ(corner_of(row(0)), 0);
}

TEST(AcCoupling, IsNoneInADrift) {
  std::vector<double> x = row();
  for (std::size_t n = 0; n < x.size(); ++n) x[n] -= 1e-4 * static_cast<double>(n);
  EXPECT_EQ(corner_of(x), 0);
}

TEST(AcCoupling, IsNoneWhereTheHammerPullsOnce) {
  std::vector<double> x = row();
  test::add_haversine(x, 700, 100, -3);
  EXPECT_EQ(corner_of(x), 0);
}

}  // namespace percuss::acquire::ac_coupling_test
