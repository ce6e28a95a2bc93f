#include "identify/start/peaks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "synth/random_stream.hpp"

namespace percuss::identify::peaks_test {

/// The definition, in quadratic time. A saddle is the lowest value between a maximum and the next higher value, or the
/// end, on one side. The prominence is the height of the maximum above the higher of its two saddles.
std::vector<Peak> by_definition(const std::vector<double>& x) {
  std::vector<Peak> peaks;
  const auto n = static_cast<std::ptrdiff_t>(x.size());
  const auto at = [&](std::ptrdiff_t i) { return x[static_cast<std::size_t>(i)]; };
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (i > 0 && at(i - 1) == at(i)) continue;
    std::ptrdiff_t end = i;
    while (end + 1 < n && at(end + 1) == at(i)) ++end;
    const bool is_top = (i == 0 || at(i - 1) < at(i)) && (end + 1 == n || at(end + 1) < at(i));
    if (!is_top || (i == 0 && end + 1 == n)) continue;
    double left = at(i), right = at(i);
    for (std::ptrdiff_t k = i - 1; k >= 0 && at(k) <= at(i); --k) left = std::min(left, at(k));
    for (std::ptrdiff_t k = end + 1; k < n && at(k) <= at(i); ++k) right = std::min(right, at(k));
    peaks.push_back({static_cast<std::size_t>((i + end) / 2), at(i) - std::max(left, right)});
  }
  return peaks;
}

void expect_same(const std::vector<Peak>& a, const std::vector<Peak>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].line, b[i].line);
    EXPECT_EQ(a[i].prominence, b[i].prominence);
  }
}

TEST(FindPeaks, GivesHeightOverTheHigherSaddle) {
  const std::vector<double> x{0, 3, 1, 5, 2, 4, 0};
  expect_same(find_peaks(x), {{1, 2}, {3, 5}, {5, 2}});
}

TEST(FindPeaks, TakesTheMiddleOfAFlatTop) {
  expect_same(find_peaks(std::vector<double>{0, 2, 2, 2, 1, 3, 3, 0}), {{2, 1}, {5, 3}});
}

TEST(FindPeaks, FindsNoneInAFlatOrEmptySequence) {
  EXPECT_TRUE(find_peaks(std::vector<double>{}).empty());
  EXPECT_TRUE(find_peaks(std::vector<double>{1}).empty());
  EXPECT_TRUE(find_peaks(std::vector<double>(50, 1.0)).empty());
}

TEST(FindPeaks, CountsAnEndAboveItsNeighbour) {
  // The end is its own saddle, so that its prominence is zero.
  expect_same(find_peaks(std::vector<double>{3, 1, 2}), {{0, 0}, {2, 0}});
}

TEST(FindPeaks, AgreesWithTheDefinitionOnRandomSequences) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    synth::RandomStream random{seed};
    std::vector<double> x(1 + seed % 60);
    // Few levels, so that plateaus, ties and equal summits are common.
    for (double& value : x) value = std::floor(random.uniform(0, seed % 2 == 0 ? 4 : 1000));
    SCOPED_TRACE(seed);
    expect_same(find_peaks(x), by_definition(x));
  }
}

TEST(FindPeaks, IsInvariantUnderReversalShiftAndScale) {
  synth::RandomStream random{7};
  std::vector<double> x(500);
  for (double& value : x) value = std::floor(random.uniform(0, 1 << 20));
  const auto peaks = find_peaks(x);
  std::vector<double> y(x.rbegin(), x.rend());
  for (double& value : y) value = 4 * value - 512;
  auto other = find_peaks(y);
  std::reverse(other.begin(), other.end());
  ASSERT_EQ(other.size(), peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i) EXPECT_EQ(other[i].prominence, 4 * peaks[i].prominence);
}

TEST(FindPeaks, IsLinearOnAStaircase) {
  // A million steps up and down with a notch at each: a search from every maximum needs 10^11 steps (minutes).
  constexpr std::size_t kCount = 1'000'000;
  constexpr double kSeconds = 5;  // a hundred times the duration of a linear method
  std::vector<double> x(kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    x[i] = static_cast<double>(std::min(i, kCount - i)) + (i % 2 == 0 ? 0.0 : 2.5);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(find_peaks(x).size(), kCount / 2);
  EXPECT_LE(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), kSeconds);
}

TEST(MaximaAbove, AreThePeaksAboveALevel) {
  const std::vector<double> level{1, 5, 5, 2, 3, 2, 4, 4};
  EXPECT_EQ(maxima_above(level, 0), (std::vector<std::size_t>{1, 4, 6}));
  EXPECT_EQ(maxima_above(level, 3), (std::vector<std::size_t>{1, 6}));
  EXPECT_TRUE(maxima_above(level, 5).empty());
  EXPECT_TRUE(maxima_above(std::vector<double>(9, 7.0), 0).empty());  // flat
  EXPECT_TRUE(maxima_above({}, 0).empty());
}

}  // namespace percuss::identify::peaks_test
