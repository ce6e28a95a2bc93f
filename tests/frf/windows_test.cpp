#include "frf/windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace percuss::frf::windows_test {

constexpr double kRounding = 1e-14;  // of products and quotients of values near 1

TEST(ExponentialWindow, DecaysFromOneAtItsOrigin) {
  std::vector<double> x(500, 2.0);
  apply_exponential(x, 30, 1000, 100);
  EXPECT_EQ(x[100], 2);
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double exact = 2 * std::exp(-0.03 * (static_cast<double>(n) - 100));
    ASSERT_LE(std::abs(x[n] - exact), kRounding * exact) << n;
  }
}

TEST(ExponentialWindow, WithoutDecayLeavesTheSamplesAlone) {
  std::vector<double> x = {1, -2.5, 3e300, 4e-310};
  const auto before = x;
  apply_exponential(x, 0, 1000, 7);
  EXPECT_EQ(x, before);
}

TEST(ExponentialWindow, AppliedTwiceAddsItsDecays) {
  std::vector<double> twice(300, 1.0), once(300, 1.0);
  apply_exponential(twice, 20, 4096, 10);
  apply_exponential(twice, 35, 4096, 10);
  apply_exponential(once, 55, 4096, 10);
  for (std::size_t n = 0; n < once.size(); ++n) ASSERT_LE(std::abs(twice[n] - once[n]), kRounding * once[n]);
}

TEST(DecayForEnd, BringsTheWindowToTheFractionGiven) {
  EXPECT_DOUBLE_EQ(decay_for_end(0.01, 1), 4.605170185988091);
  EXPECT_EQ(decay_for_end(1, 3), 0);
  std::vector<double> x(1001, 1.0);
  apply_exponential(x, decay_for_end(0.003, 0.25), 4000, 0);  // 1000 samples last 0.25 s
  EXPECT_LE(std::abs(x[1000] - 0.003), kRounding);
}

}  // namespace percuss::frf::windows_test
