#include "identify/select/robust_mean.hpp"

#include <gtest/gtest.h>

namespace percuss::identify::robust_mean_test {

const std::vector<double> kFrequencies{100.1, 99.9, 100.05, 99.95, 100.0};

TEST(RobustMean, IsThePlainMeanOfValuesOfOneSize) {
  const RobustMean mean = robust_mean(kFrequencies, std::vector<double>(5, 0.001), std::vector<double>(5, 1));
  EXPECT_NEAR(mean.value, 100, 1e-6);
  EXPECT_NEAR(mean.spread, 0.079, 0.001);  // √(0.025/4)
}

TEST(RobustMean, GivesLittleWeightToANodeAndToAnOutlier) {
  std::vector<double> values = kFrequencies, size(7, 1);
  values.push_back(100.3);  // near a node
  values.push_back(104);    // an outlier
  size[5] = 0.03;
  const RobustMean mean = robust_mean(values, std::vector<double>(7, 0.001), size);
  EXPECT_NEAR(mean.value, 100, 0.05);
  EXPECT_LT(mean.spread, 0.5);
}

TEST(WeightedMedian, FollowsTheWeight) {
  EXPECT_EQ(weighted_median({3, 1, 2}, {1, 1, 1}), 2);
  EXPECT_EQ(weighted_median({3, 1, 2}, {5, 1, 1}), 3);
}

}  // namespace percuss::identify::robust_mean_test
