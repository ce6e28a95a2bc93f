#include "identify/line_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/modal_lines.hpp"

namespace percuss::line_noise_test {

// A median over some thousand lines of which three neighbours share their noise is good to 5 %; five of its deviations.
constexpr double kTolerance = 0.1;
constexpr double kPart = 0.01;  // deviation of a real part
constexpr double kWhole = kPart * std::numbers::sqrt2;
constexpr Pole kMode{.freq_Hz = 800, .damping_ratio = 0.004};

FrfSet noisy_mode() {
  FrfSet set = test::empty_set(8192, 16384, 40, 2400, 2);
  test::add_mode(set, 0, kMode, 1);
  test::add_mode(set, 1, kMode, 0.3);
  test::add_line_noise(set, kPart, 1);
  return set;
}

// As the same response's noise makes it where the force falls with frequency: 1/|F| above the first line.
double amplitude(std::size_t line) { return 1 / (1 + 1e-3 * static_cast<double>(line)); }

TEST(LineNoise, IsThatOfTheLinesWhateverResonatesAmongThem) {
  const FrfSet set = noisy_mode();
  const LineNoise noise(set);
  for (std::size_t output = 0; output < 2; ++output) {
    EXPECT_NEAR(noise.at(output, 100) / kWhole, 1, kTolerance);
    EXPECT_NEAR(noise.at(output, 100), noise.at(output, 4000), 1e-12);  // the force of one sample is even
    EXPECT_NEAR(noise.over(0, set.lines.count)(static_cast<Eigen::Index>(output)), noise.at(output, 0), 1e-12);
  }
}

TEST(LineNoise, GoesAsOneOverTheForce) {
  FrfSet set = noisy_mode();
  for (std::size_t k = 0; k < set.lines.count; ++k) {
    for (Output& output : set.outputs) output.frf[k] /= amplitude(k);
    set.points[0].ff[k] = std::pow(amplitude(k), 2);
  }
  const LineNoise noise(set);
  for (const std::size_t line : {0U, 1000U, 4000U})
    EXPECT_NEAR(noise.at(1, line) * amplitude(line) / kWhole, 1, kTolerance) << line;
  // Over some lines: as strong as where the force has their mean power.
  const double power = (std::pow(amplitude(2000), 2) + std::pow(amplitude(2001), 2)) / 2;
  EXPECT_NEAR(noise.over(2000, 2)(0) / (noise.at(0, 0) / std::sqrt(power)), 1, 1e-9);
}

TEST(LineNoise, IsEvenWhereTheForceIsNotKnown) {
  FrfSet set = noisy_mode();
  set.points[0].ff.clear();
  const LineNoise noise(set);
  EXPECT_NEAR(noise.at(0, 7) / kWhole, 1, kTolerance);
  EXPECT_EQ(noise.over(10, 20)(0), noise.at(0, 7));
}

TEST(LineNoise, IsNeverZero) {
  FrfSet set = test::empty_set(8192, 16384, 40, 2400, 2);
  test::add_mode(set, 0, kMode, 1);
  const LineNoise noise(set);
  EXPECT_GT(noise.at(0, 100), 0);
  EXPECT_GT(noise.at(1, 100), 0);  // a dead output
}

TEST(Roughness, TellsNothingOfTheEndsNorOfAStraightLine) {
  const std::vector<Complex> lines{{1, 0}, {2, 1}, {3, 2}, {3, 8}};
  const auto rough = roughness(lines);
  ASSERT_EQ(rough.size(), 4U);
  EXPECT_EQ(rough[0], 0);
  EXPECT_EQ(rough[1], 0);
  EXPECT_NEAR(rough[2], std::norm(Complex(0.5, -2.5)) / 1.5, 1e-12);
  EXPECT_EQ(rough[3], 0);
  EXPECT_TRUE(roughness({}).empty());
}

TEST(NoisePower, SkipsResonances) {
  std::vector<double> rough(1001, 0.693147);
  for (std::size_t i = 0; i < 333; ++i) rough[3 * i] = 1e6;  // narrow ones everywhere
  std::fill(rough.begin(), rough.begin() + 300, 1e6);        // a broad one
  EXPECT_NEAR(noise_power(rough), 1, 1e-6);
  EXPECT_EQ(noise_power({}), 0);
}

TEST(BlockNoise, TellsItBlockByBlock) {
  std::vector<double> rough(3 * kNoiseBlock - 1, 0.693147);
  std::fill(rough.begin() + kNoiseBlock, rough.end(), 4 * 0.693147);
  const auto noise = block_noise(rough);
  ASSERT_EQ(noise.size(), 2U);  // the second one has the rest
  EXPECT_NEAR(noise[0], 1, 1e-6);
  EXPECT_NEAR(noise[1], 4, 1e-6);
  EXPECT_EQ(block_noise(std::vector<double>(3, 1.0)).size(), 1U);
}

}  // namespace percuss::line_noise_test
