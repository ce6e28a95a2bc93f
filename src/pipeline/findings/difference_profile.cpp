#include "pipeline/findings/difference_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/math/statistics.hpp"
#include "core/math/wide_loops.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kOutstanding = 8;        // times the rms around: fewer than 1 of a million noise samples reach 5 times
constexpr std::size_t kBlocksAround = 2;  // blocks on either side

// Standard deviation of the differences of white noise of unit variance: √C(2n, n).
double noise_gain() {
  double square = 1;
  for (std::size_t i = 1; i <= kDifferenceOrder; ++i)
    square *= static_cast<double>(kDifferenceOrder + i) / static_cast<double>(i);
  return std::sqrt(square);
}

// Differences of the samples, scaled; shorter than x by the order. One pass for four orders: the compiler vectorises
// it.
PERCUSS_WIDE_LOOPS std::span<const double> differences(std::span<const double> x, double scale,
                                                       std::span<double> work) {
  for (std::size_t i = 0; i < x.size(); ++i) work[i] = x[i] * scale;
  static_assert(kDifferenceOrder % 4 == 0);
  std::size_t n = x.size();
  for (std::size_t order = 0; order < kDifferenceOrder; order += 4) {
    n -= 4;
    for (std::size_t i = 0; i < n; ++i)
      work[i] = (work[i] + work[i + 4]) - 4 * (work[i + 1] + work[i + 3]) + 6 * work[i + 2];
  }
  return work.first(n);
}

struct Size {
  double square = 0;   // Σ x²
  double largest = 0;  // |x|
};

// Several sums at a time, so that none waits for the one before it.
PERCUSS_WIDE_LOOPS Size size_of(std::span<const double> x) {
  constexpr std::size_t kLanes = 8;
  FourDoubles square{}, square2{}, high{}, high2{}, low{}, low2{}, a{}, b{};
  std::size_t i = 0;
  for (; i + kLanes <= x.size(); i += kLanes) {
    std::memcpy(&a, x.data() + i, sizeof(a));
    std::memcpy(&b, x.data() + i + kLanes / 2, sizeof(b));
    square += a * a;
    square2 += b * b;
    high = high > a ? high : a;
    high2 = high2 > b ? high2 : b;
    low = low < a ? low : a;
    low2 = low2 < b ? low2 : b;
  }
  Size out;
  square += square2;
  for (std::size_t k = 0; k < kLanes / 2; ++k) {
    out.square += square[k];
    out.largest = std::max({out.largest, high[k], high2[k], -low[k], -low2[k]});
  }
  for (; i < x.size(); ++i) {
    out.square += x[i] * x[i];
    out.largest = std::max(out.largest, std::abs(x[i]));
  }
  return out;
}

}  // namespace

DifferenceProfile difference_profile(std::span<const double> x, std::size_t first) {
  DifferenceProfile profile{.first = first, .rms = {}, .largest = {}, .at = {}};
  const double scale = 1 / noise_gain();
  std::array<double, kDifferenceBlock + kDifferenceOrder> work{};
  for (std::size_t begin = first; begin + work.size() <= x.size(); begin += kDifferenceBlock) {
    const auto d = differences(x.subspan(begin, work.size()), scale, work);
    const Size size = size_of(d);
    const auto at = std::find_if(d.begin(), d.end(), [&](double value) { return std::abs(value) == size.largest; });
    profile.rms.push_back(std::sqrt(size.square / static_cast<double>(d.size())));
    profile.largest.push_back(size.largest);
    profile.at.push_back(begin + static_cast<std::size_t>(at - d.begin()) + kDifferenceOrder / 2);
  }
  return profile;
}

std::optional<double> difference_rms(std::span<const double> x) {
  if (x.size() < 2 * kDifferenceOrder) return std::nullopt;
  std::vector<double> work(x.size());
  return rms(differences(x, 1 / noise_gain(), work));
}

std::vector<std::size_t> outstanding_samples(const DifferenceProfile& profile, std::size_t most, double least) {
  std::vector<std::pair<double, std::size_t>> found;
  const std::size_t blocks = profile.rms.size();
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t from = b > kBlocksAround ? b - kBlocksAround : 0;
    const std::size_t to = std::min(blocks, b + kBlocksAround + 1);
    const auto first = profile.rms.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = profile.rms.begin() + static_cast<std::ptrdiff_t>(to);
    // The minimum is not above the median, so few blocks need the median.
    if (profile.largest[b] <= std::max(least, kOutstanding * *std::min_element(first, end))) continue;
    const double around = median({first, end});
    if (profile.largest[b] > kOutstanding * around && around > 0)
      found.emplace_back(profile.largest[b] / around, profile.at[b]);
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  std::vector<std::size_t> samples;
  for (const auto& [ratio, at] : found) {
    if (samples.size() < most) samples.push_back(at);
  }
  return samples;
}

}  // namespace percuss::pipeline
