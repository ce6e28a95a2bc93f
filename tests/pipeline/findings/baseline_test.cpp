#include "pipeline/findings/baseline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace percuss::pipeline::baseline_test {

RestLevels levels_after(std::initializer_list<double> after) {
  RestLevels levels{.before = 0.0, .quiet = 100, .first = 100, .window = 100};
  std::copy(after.begin(), after.end(), levels.after.begin());
  return levels;
}

TEST(BaselineChange, IsAStepThatDecays) {
  // A unit step with the time constant of one window: the means of the windows, (1 - 1/e) e^-w.
  const double e = std::exp(-1.0);
  const auto change =
      find_baseline_change(levels_after({1 - e, (1 - e) * e, (1 - e) * e * e, (1 - e) * e * e * e}), 1600, 10, 1000);
  ASSERT_TRUE(change && change->step);
  EXPECT_NEAR(change->size, 1, 1e-9);
  EXPECT_NEAR(change->decay_per_s, 10, 1e-7);
}

TEST(BaselineChange, IsNoneWhereTheShiftsCancel) {
  // Both sums of shifts are exactly zero, so that their ratio is not a number.
  EXPECT_FALSE(find_baseline_change(levels_after({1, 0.5, -1.5, 1}), 1600, 10, 1000));
}

// The mean of the 100 samples before the hit is uncertain by a tenth of their standard deviation.
TEST(BaselineChange, ExceedsTheNoiseOfTheMeanBefore) {
  RestLevels decaying = levels_after({1, 0.5, 0.25, 0.125});
  decaying.noise = 1.9;
  EXPECT_TRUE(find_baseline_change(decaying, 1600, 10, 1000)) << "5.3 standard deviations of the mean";
  decaying.noise = 2.1;
  EXPECT_FALSE(find_baseline_change(decaying, 1600, 10, 1000)) << "4.8 standard deviations of the mean";
}

}  // namespace percuss::pipeline::baseline_test
