#include "pipeline/findings/difference_profile.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math/statistics.hpp"

namespace percuss::pipeline {
namespace {

constexpr double kOutstanding = 8;        // times the rms around: 1 of a million noise samples reaches 5 times
constexpr std::size_t kBlocksAround = 2;  // blocks on either side

// Standard deviation of the differences of white noise of unit variance: √C(2n, n).
double noise_gain() {
  double square = 1;
  for (std::size_t i = 1; i <= kDifferenceOrder; ++i)
    square *= static_cast<double>(kDifferenceOrder + i) / static_cast<double>(i);
  return std::sqrt(square);
}

// Differences of the samples, scaled; shorter than x by the order. One pass for two orders: the compiler vectorises it.
std::span<const double> differences(std::span<const double> x, std::span<double> work) {
  static const double scale = 1 / noise_gain();
  for (std::size_t i = 0; i < x.size(); ++i) work[i] = x[i] * scale;
  static_assert(kDifferenceOrder % 2 == 0);
  std::size_t n = x.size();
  for (std::size_t order = 0; order < kDifferenceOrder; order += 2) {
    n -= 2;
    for (std::size_t i = 0; i < n; ++i) work[i] = (work[i + 2] - work[i + 1]) - (work[i + 1] - work[i]);
  }
  return work.first(n);
}

struct Size {
  double square = 0;   // Σ x²
  double largest = 0;  // |x|
};

// Several sums at a time, so that none waits for the one before it.
Size size_of(std::span<const double> x) {
  using Row = Eigen::Array<double, 8, 1>;
  Row square = Row::Zero(), largest = Row::Zero();
  std::size_t i = 0;
  for (; i + 8 <= x.size(); i += 8) {
    const Eigen::Map<const Row> row(x.data() + i);
    square += row * row;
    largest = largest.max(row.abs());
  }
  Size out{.square = square.sum(), .largest = largest.maxCoeff()};
  for (; i < x.size(); ++i) {
    out.square += x[i] * x[i];
    out.largest = std::max(out.largest, std::abs(x[i]));
  }
  return out;
}

}  // namespace

DifferenceProfile difference_profile(std::span<const double> x, std::size_t first) {
  DifferenceProfile profile{.first = first, .rms = {}, .largest = {}, .at = {}};
  std::array<double, kDifferenceBlock + kDifferenceOrder> work{};
  for (std::size_t begin = first; begin + work.size() <= x.size(); begin += kDifferenceBlock) {
    const auto d = differences(x.subspan(begin, work.size()), work);
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
  return rms(differences(x, work));
}

std::vector<std::size_t> outstanding_samples(const DifferenceProfile& profile, std::size_t most, double least) {
  std::vector<std::pair<double, std::size_t>> found;
  const std::size_t blocks = profile.rms.size();
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t from = b > kBlocksAround ? b - kBlocksAround : 0;
    const std::size_t to = std::min(blocks, b + kBlocksAround + 1);
    if (profile.largest[b] <= least) continue;
    const double around = median({profile.rms.begin() + static_cast<std::ptrdiff_t>(from),
                                  profile.rms.begin() + static_cast<std::ptrdiff_t>(to)});
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
