#include "identify/fit/pole_update.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percuss::identify::pole_update_test {

TEST(PoleUpdate, AllowsPositiveFrequenciesAndDampingRatiosBelowOneHalf) {
  EXPECT_TRUE(poles_in_bounds({{100, 0.01}, {100.1, 0.49}}));
  EXPECT_FALSE(poles_in_bounds({{-1, 0.01}}));
  EXPECT_FALSE(poles_in_bounds({{100, 0}}));
  EXPECT_FALSE(poles_in_bounds({{100, 0.6}}));
  EXPECT_FALSE(poles_in_bounds({{std::numeric_limits<double>::quiet_NaN(), 0.1}}));
}

TEST(PoleUpdate, IsMeasuredInHalfBandwidths) {
  const std::vector<Pole> poles{{100, 0.01}, {200, 0.02}};
  Eigen::VectorXd step(4);
  step << 0.5, 0.001, -1, -0.004;
  const auto after = updated_poles(poles, step);
  EXPECT_EQ(after[0].freq_Hz, 100.5);
  EXPECT_EQ(after[1].damping_ratio, 0.016);
  EXPECT_DOUBLE_EQ(normalised_step(step, poles), 0.5);  // 0.5 Hz over half of 2 Hz
}

}  // namespace percuss::identify::pole_update_test
