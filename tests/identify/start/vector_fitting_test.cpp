#include "identify/start/vector_fitting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/modal_frfs.hpp"

namespace percuss::identify::vector_fitting_test {

// Twelve poles, 60 Hz apart, each with a half-power bandwidth of 40 Hz.
std::vector<Pole> twelve_poles() {
  std::vector<Pole> poles;
  for (int m = 0; m < 12; ++m) {
    const double freq_Hz = 200 + 60 * m;
    poles.push_back({.freq_Hz = freq_Hz, .damping_ratio = 20 / freq_Hz});
  }
  return poles;
}

FrfDataset set_of(const std::vector<Pole>& poles, double noise) {
  FrfDataset set = test::empty_set(8192, 8192, 40, 1100, 2);
  for (std::size_t m = 0; m < poles.size(); ++m) {
    test::add_mode(set, 0, poles[m], 0.8 + 0.1 * static_cast<double>(m % 3));
    test::add_mode(set, 1, poles[m], m % 2 == 0 ? 0.5 : -0.3);
  }
  if (noise > 0) test::add_frf_noise(set, noise, 3);
  return set;
}

void expect_near(const std::vector<Pole>& found, const std::vector<Pole>& truth, double bandwidths) {
  for (const Pole& pole : truth) {
    double nearest_Hz = 1e9;
    for (const Pole& other : found) nearest_Hz = std::min(nearest_Hz, std::abs(other.freq_Hz - pole.freq_Hz));
    EXPECT_LT(nearest_Hz, bandwidths * pole.half_power_Hz()) << pole.freq_Hz;
  }
}

// Rounding errors alone.
TEST(VectorFitting, ReturnsThePolesOfFrfsWithoutNoise) {
  const std::vector<Pole> truth = twelve_poles();
  const std::vector<Pole> found = vector_fitting_poles(set_of(truth, 0), truth.size(), 0);
  ASSERT_EQ(found.size(), truth.size());
  expect_near(found, truth, 1e-6);
}

// The noise is below a thousandth of the peaks.
TEST(VectorFitting, FindsThemAmongMorePolesThanModes) {
  const std::vector<Pole> truth = twelve_poles();
  expect_near(vector_fitting_poles(set_of(truth, 1e-3), 16, 0), truth, 0.05);
  expect_near(vector_fitting_poles(set_of(truth, 1e-3), 16, 8), truth, 0.1);  // averages over 8 lines
}

TEST(VectorFitting, FindsNothingWithTooFewLinesPolesOrChannels) {
  const FrfDataset set = set_of(twelve_poles(), 0);
  EXPECT_TRUE(vector_fitting_poles(set, set.lines.count / 4 + 1, 0).empty());
  EXPECT_TRUE(vector_fitting_poles(set, 1, 0).empty());
  EXPECT_TRUE(vector_fitting_poles(test::empty_set(8192, 8192, 40, 1100, 0), 12, 0).empty());
}

}  // namespace percuss::identify::vector_fitting_test
