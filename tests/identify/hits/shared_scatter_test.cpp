#include "identify/hits/shared_scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/significance.hpp"
#include "identify/hits/hit_scatter.hpp"

namespace percuss::identify::shared_scatter_test {

// Five hits with a standard deviation of 1.
const std::vector<double> kHits = {0.9, -0.4, -1.3, 1.1, -0.3};

RelativeHitValues mode(double scatter, double std, std::size_t window, bool significant) {
  RelativeHitValues out{.value = {}, .std = std::vector<double>(kHits.size(), std), .window = window};
  for (const double hit : kHits) out.value.push_back(1 + scatter * hit);
  if (significant) out.spread = scatter_of_hits(out.value, out.std).spread;
  return out;
}
RelativeHitValues scattering(double scatter, std::size_t window) { return mode(scatter, 1e-6, window, true); }
// Its noise is as large as the scatter of the others.
RelativeHitValues weak(std::size_t window) { return mode(30e-6, 30e-6, window, false); }
RelativeHitValues steady(std::size_t window) { return mode(1e-6, 1e-6, window, false); }

TEST(SharedScatter, IsThatOfTheModesThatAgree) {
  const SharedScatter shared = shared_scatter({scattering(30e-6, 0), scattering(35e-6, 1), weak(2), steady(3)});
  EXPECT_NEAR(shared.spread, 32e-6, 3e-6);
  ASSERT_EQ(shared.probability.size(), 4U);
  EXPECT_EQ(shared.probability[0], 1);
  EXPECT_GT(shared.probability[2], 0.3);
  EXPECT_LT(shared.probability[2], 0.9);
  EXPECT_EQ(shared.probability[3], 0) << "its hits exclude the scatter";
}

TEST(SharedScatter, IsLessProbableIfMostModesExcludeIt) {
  const std::vector<RelativeHitValues> few{scattering(30e-6, 0), scattering(30e-6, 1), weak(2)};
  std::vector<RelativeHitValues> many = few;
  for (std::size_t window = 3; window < 9; ++window) many.push_back(steady(window));
  EXPECT_LT(shared_scatter(many).probability[2], 0.5 * shared_scatter(few).probability[2]);
}

TEST(SharedScatter, IsNotTakenFromOneMode) {
  EXPECT_EQ(shared_scatter({scattering(30e-6, 0), weak(1), weak(2)}).spread, 0);
  EXPECT_EQ(shared_scatter({scattering(30e-6, 0), scattering(30e-6, 0), weak(1)}).spread, 0) << "a close pair";
  EXPECT_EQ(shared_scatter({weak(0), weak(1)}).spread, 0);
  EXPECT_EQ(shared_scatter({}).spread, 0);
}

TEST(SharedScatter, IsNotTakenFromModesThatDisagree) {
  EXPECT_EQ(shared_scatter({scattering(10e-6, 0), scattering(300e-6, 1), weak(2)}).spread, 0);
  const SharedScatter most = shared_scatter(
      {scattering(30e-6, 0), scattering(35e-6, 1), scattering(30e-6, 2), scattering(900e-6, 3), weak(4)});
  EXPECT_NEAR(most.spread, 32e-6, 3e-6);
}

// The same as for a mode that scatters itself.
TEST(SharedScatter, HasTheStandardDeviationOfTheMeanOfTheHits) {
  const std::vector<double> std(5, 30e-6);
  EXPECT_NEAR(std_from_shared_scatter(std, 5, 20e-6, 1), student_factor(4) * 20e-6 / std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(std_from_shared_scatter(std, 5, 20e-6, 0.25), 0.5 * student_factor(4) * 20e-6 / std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(std_from_shared_scatter({}, 5, 20e-6, 1), student_factor(4) * 20e-6 / std::sqrt(5.0), 1e-12);
  EXPECT_EQ(std_from_shared_scatter(std, 5, 0, 1), 0);
}

}  // namespace percuss::identify::shared_scatter_test
