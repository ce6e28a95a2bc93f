#include "synth/random_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace percuss::synth::random_stream_test {

TEST(RandomStream, DependsOnItsNameOnly) {
  RandomStream a{1, 2}, again{1, 2}, swapped{2, 1};
  const double first = a.uniform();
  EXPECT_EQ(first, again.uniform());
  EXPECT_NE(first, swapped.uniform());
}

TEST(RandomStream, NormalsHaveTheirMoments) {
  std::vector<double> x(200001, 0.0);
  RandomStream{7, 3}.add_normal(2, x);
  double mean = 0, second = 0, fourth = 0;
  for (const double v : x) {
    mean += v / 2;
    second += v * v / 4;
    fourth += std::pow(v / 2, 4);
  }
  const auto n = static_cast<double>(x.size());
  EXPECT_LE(std::abs(mean / n), 5 / std::sqrt(n));             // five standard deviations each: 1/√n,
  EXPECT_LE(std::abs(second / n - 1), 5 * std::sqrt(2 / n));   // √(2/n),
  EXPECT_LE(std::abs(fourth / n - 3), 5 * std::sqrt(96 / n));  // √(96/n)
}

}  // namespace percuss::synth::random_stream_test
