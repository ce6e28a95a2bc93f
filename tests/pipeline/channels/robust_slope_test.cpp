#include "pipeline/channels/robust_slope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace percuss::pipeline::robust_slope_test {

// y = slope·x with errors of these standard deviations.
RobustSlope fitted(double slope, const std::vector<double>& std, double scatter, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x, y;
  for (std::size_t i = 0; i < std.size(); ++i) {
    x.push_back(static_cast<double>(i + 1));
    y.push_back(slope * x.back() + std::hypot(std[i], scatter) * normal(random));
  }
  return robust_slope(x, y, std);
}

TEST(RobustSlope, StandardDeviationCoversNoiseAndScatter) {
  for (const double scatter : {0.0, 0.3}) {
    double chi2 = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const RobustSlope fit = fitted(0.5, std::vector<double>(12, 0.01), scatter, seed);
      chi2 += std::pow((fit.slope - 0.5) / fit.std, 2) / 200;
    }
    // The mean of 200 squares scatters by 0.1, and more because each ± is estimated from 12 values.
    EXPECT_GT(chi2, 0.5) << scatter;
    EXPECT_LT(chi2, 1.6) << scatter;
  }
}

TEST(RobustSlope, IsNotPulledByOneFarValue) {
  std::vector<double> x, y, std(10, 0.01);
  for (int i = 1; i <= 10; ++i) {
    x.push_back(i);
    y.push_back(0.5 * i);
  }
  y[9] = 50;
  EXPECT_NEAR(robust_slope(x, y, std).slope, 0.5, 0.01);
}

TEST(RobustSlope, OnlyATrueSlopeIsUnlikelyByChance) {
  int chance = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
    chance += fitted(0, std::vector<double>(6, 0.1), 1, seed).log_chance < kMaxLogChance;
  EXPECT_EQ(chance, 0);
  EXPECT_LT(fitted(1, std::vector<double>(6, 0.01), 0, 1).log_chance, kMaxLogChance);
}

}  // namespace percuss::pipeline::robust_slope_test
