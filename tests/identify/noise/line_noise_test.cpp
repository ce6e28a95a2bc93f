#include "identify/noise/line_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/math/statistics.hpp"
#include "identify/noise/window_noise.hpp"
#include "support/modal_frfs.hpp"

namespace percuss::identify::line_noise_test {

// Five standard deviations of the median over 73 blocks, where the noise of a block is itself the median of 32 second
// differences (of the last block: 56).
constexpr double kTolerance = 0.1;
constexpr double kRealStd = 0.01;  // of a real part
constexpr double kComplexStd = kRealStd * std::numbers::sqrt2;
constexpr Pole kMode{.freq_Hz = 800, .damping_ratio = 0.004};

FrfDataset noisy_mode() {
  FrfDataset set = test::empty_set(8192, 16384, 40, 2400, 2);
  test::add_mode(set, 0, kMode, 1);
  test::add_mode(set, 1, kMode, 0.3);
  test::add_frf_noise(set, kRealStd, 1);
  return set;
}

// The amplitude of a force that falls with frequency, relative to the first line.
double amplitude(std::size_t line) { return 1 / (1 + 1e-3 * static_cast<double>(line)); }

TEST(LineNoise, DoesNotDependOnResonances) {
  const FrfDataset set = noisy_mode();
  const LineNoise noise(set);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    EXPECT_NEAR(noise.at(channel, 100) / kComplexStd, 1, kTolerance);
    EXPECT_NEAR(noise.at(channel, 100), noise.at(channel, 4000), 1e-12);  // a force of one sample has a white spectrum
    EXPECT_NEAR(noise.over(0, set.lines.count)(static_cast<Eigen::Index>(channel)), noise.at(channel, 0), 1e-12);
  }
}

TEST(LineNoise, IsInverselyProportionalToTheForce) {
  FrfDataset set = noisy_mode();
  for (std::size_t k = 0; k < set.lines.count; ++k) {
    for (FrfChannel& channel : set.channels) channel.frf[k] /= amplitude(k);
    set.points[0].ff[k] = std::pow(amplitude(k), 2);
  }
  const LineNoise noise(set);
  for (const std::size_t line : {0U, 1000U, 4000U})
    EXPECT_NEAR(noise.at(1, line) * amplitude(line) / kComplexStd, 1, kTolerance) << line;
  // Over a range of lines: the noise at the mean power of the force.
  const double power = (std::pow(amplitude(2000), 2) + std::pow(amplitude(2001), 2)) / 2;
  EXPECT_NEAR(noise.over(2000, 2)(0) / (noise.at(0, 0) / std::sqrt(power)), 1, 1e-9);
}

TEST(LineNoise, IsWhiteWhereTheForceIsUnknown) {
  FrfDataset set = noisy_mode();
  set.points[0].ff.clear();
  const LineNoise noise(set);
  EXPECT_NEAR(noise.at(0, 7) / kComplexStd, 1, kTolerance);
  EXPECT_EQ(noise.over(10, 20)(0), noise.at(0, 7));
}

TEST(LineNoise, IsNeverZero) {
  FrfDataset set = test::empty_set(8192, 16384, 40, 2400, 2);
  test::add_mode(set, 0, kMode, 1);
  const LineNoise noise(set);
  EXPECT_GT(noise.at(0, 100), 0);
  EXPECT_GT(noise.at(1, 100), 0);  // a dead channel
}

std::vector<Complex> noise_of(std::size_t lines, std::uint64_t seed) {
  FrfDataset set = test::empty_set(8192, 16384, 0, 4096, 1);
  test::add_frf_noise(set, std::sqrt(0.5), seed);
  set.channels[0].frf.resize(lines);
  return set.channels[0].frf;
}

TEST(BlockNoise, SkipsResonances) {
  auto lines = noise_of(4000, 3);
  for (std::size_t k = 0; k < 4000; k += 64) lines[k] += 1e3;  // narrow resonances everywhere
  const auto broad = noise_of(400, 4);
  for (std::size_t k = 0; k < 400; ++k) lines[k] += 1e3 * broad[k];
  // The median of the 62 blocks, each a median of 32 exponential values, is accurate to 4 %. The narrow resonances
  // raise it by 10 %, the broad one by 3 %.
  EXPECT_NEAR(median(block_noise(lines, kWhiteRoughness)), 1, 0.25);
}

TEST(BlockNoise, IsSeparateForEachBlock) {
  auto lines = noise_of(100 * kNoiseBlock - 1, 5);
  for (std::size_t k = 50 * kNoiseBlock; k < lines.size(); ++k)
    lines[k] = 2.0 * lines[k] + Complex(0.1, 3) * static_cast<double>(k);
  const auto noise = block_noise(lines, kWhiteRoughness);
  ASSERT_EQ(noise.size(), 99U);  // the last block has the rest
  const auto mean = [&](std::size_t from, std::size_t to) {
    return std::accumulate(noise.begin() + static_cast<std::ptrdiff_t>(from),
                           noise.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
           static_cast<double>(to - from);
  };
  // A median of 32 values is high by 2 %. The mean of 50 medians is accurate to 4 %. The tolerance is 2 % + 3 · 4 %.
  EXPECT_NEAR(mean(0, 49), 1, 0.14);
  EXPECT_NEAR(mean(51, 99), 4, 0.56);
  EXPECT_TRUE(block_noise(std::vector<Complex>(2), kWhiteRoughness).empty());
  EXPECT_EQ(block_noise(std::vector<Complex>(3), kWhiteRoughness).size(), 1U);
}

TEST(LocalNoise, IsTheMedianOfThreeBlocks) {
  const std::vector<double> blocks{1, 9, 2, 4};
  const auto noise = local_noise(blocks, 4 * kNoiseBlock + 5);
  ASSERT_EQ(noise.size(), 4 * kNoiseBlock + 5);
  EXPECT_EQ(noise[0], 5);  // two blocks at an end: their mean
  EXPECT_EQ(noise[kNoiseBlock], 2);
  EXPECT_EQ(noise[3 * kNoiseBlock - 1], 4);
  EXPECT_EQ(noise.back(), 3);
  EXPECT_TRUE(local_noise({}, 0).empty());
}

}  // namespace percuss::identify::line_noise_test
