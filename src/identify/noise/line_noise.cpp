#include "identify/noise/line_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMedianOfNoise = 0.693147;  // median of an exponential distribution: |complex Gaussian|²
// Of the largest line: rounding noise. It keeps the weights of a noise-free FRF finite.
constexpr double kMinRelativeNoise = 1e-12;
constexpr double kMinPower = 1e-300;
constexpr std::size_t kStride = 8;  // every eighth line is tested for the largest
constexpr std::size_t kFlopsPerNoiseLine = 20;

// One past the last line of a block, when the lines make `blocks` blocks.
std::size_t end_of(std::size_t block, std::size_t blocks, std::size_t lines) {
  return block + 1 < blocks ? (block + 1) * kNoiseBlock : lines;
}

std::size_t middle_of(std::size_t block, std::size_t blocks, std::size_t lines) {
  return (block * kNoiseBlock + end_of(block, blocks, lines)) / 2;
}

double response_noise(const std::vector<Complex>& frf, const std::vector<double>& ff, std::vector<double> blocks) {
  double largest = 0;  // approximate: rounding noise is known only to its order of magnitude
  for (std::size_t k = 0; k < frf.size(); k += kStride)
    largest = std::max(largest, std::norm(frf[k]) * (ff.empty() ? 1 : ff[k]));
  // The force is smooth: its value at the middle line stands for the block.
  for (std::size_t b = 0; b < blocks.size() && !ff.empty(); ++b)
    blocks[b] *= ff[middle_of(b, blocks.size(), ff.size())];
  return std::sqrt(std::max({median(std::move(blocks)), kMinRelativeNoise * kMinRelativeNoise * largest, kMinPower}));
}

}  // namespace

LineNoise::LineNoise(const FrfDataset& set) : set_(set), response_(static_cast<Index>(set.channels.size())) {
  blocks_.resize(set.channels.size());
  const double roughness = WindowNoise(set).roughness();
  parallel_for_cost(set.channels.size(), kFlopsPerNoiseLine * set.lines.count, [&](std::size_t o) {
    const std::vector<Complex>& frf = set.channels[o].frf;
    blocks_[o] = block_noise(frf, roughness);
    response_(static_cast<Index>(o)) = response_noise(frf, set.points[set.channels[o].point].ff, blocks_[o]);
  });
}

std::vector<double> LineNoise::local(std::size_t channel) const {
  return local_noise(blocks_[channel], set_.channels[channel].frf.size());
}

double LineNoise::at(std::size_t channel, std::size_t line) const {
  const std::vector<double>& ff = set_.points[set_.channels[channel].point].ff;
  return response_(static_cast<Index>(channel)) / (ff.empty() ? 1 : std::sqrt(std::max(ff[line], kMinPower)));
}

Eigen::VectorXd LineNoise::over(std::size_t first, std::size_t count) const {
  Eigen::VectorXd force = Eigen::VectorXd::Ones(static_cast<Index>(set_.points.size()));
  parallel_for_cost(set_.points.size(), count, [&](std::size_t p) {
    const std::vector<double>& ff = set_.points[p].ff;
    if (ff.empty()) return;
    const Eigen::Map<const Eigen::ArrayXd> power(ff.data() + first, static_cast<Index>(count));
    force(static_cast<Index>(p)) = std::sqrt(std::max(power.mean(), kMinPower));
  });
  Eigen::VectorXd noise = response_;
  for (std::size_t o = 0; o < set_.channels.size(); ++o)
    noise(static_cast<Index>(o)) /= force(static_cast<Index>(set_.channels[o].point));
  return noise;
}

std::vector<double> block_noise(std::span<const Complex> lines, double roughness) {
  if (lines.size() < 3) return {};
  std::vector<double> noise(std::max<std::size_t>(lines.size() / kNoiseBlock, 1));
  std::vector<double> rough;
  for (std::size_t b = 0; b < noise.size(); ++b) {
    const std::size_t end = end_of(b, noise.size(), lines.size());
    rough.clear();
    for (std::size_t k = b * kNoiseBlock + 1; k < end && k + 1 < lines.size(); k += 2)
      rough.push_back(std::norm(lines[k] - 0.5 * (lines[k - 1] + lines[k + 1])) / roughness);
    noise[b] = median(rough) / kMedianOfNoise;
  }
  return noise;
}

std::vector<double> local_noise(std::span<const double> blocks, std::size_t lines) {
  std::vector<double> noise(lines);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t first = b > 0 ? b - 1 : 0, last = std::min(b + 1, blocks.size() - 1);
    const auto around = blocks.subspan(first, last - first + 1);
    const std::size_t end = end_of(b, blocks.size(), lines);
    std::fill(noise.begin() + static_cast<std::ptrdiff_t>(b * kNoiseBlock),
              noise.begin() + static_cast<std::ptrdiff_t>(end), median({around.begin(), around.end()}));
  }
  return noise;
}

}  // namespace percuss::identify
