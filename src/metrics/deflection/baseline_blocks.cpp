#include "metrics/deflection/baseline_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/units.hpp"

namespace percuss::metrics {
namespace {

constexpr double kGrowth = 1.3;  // width of a block over the width of its neighbour
// How many of the narrowest and of the widest blocks would cover the rest, and the motion.
constexpr double kNarrowestPerRest = 80, kWidestPerRest = 12;
constexpr double kNarrowestPerMotion = 1500, kWidestPerMotion = 32;
constexpr double kSlowest = 0.1;  // lowest rate over the inverse of the record's length

// Ends of blocks that begin at 0 and cover `samples`; their widths grow from `narrowest` to `widest`.
std::vector<std::size_t> block_ends(std::size_t samples, double narrowest, double widest) {
  std::vector<std::size_t> ends;
  std::size_t end = 0;
  for (double width = narrowest; end < samples; width *= kGrowth) {
    end += std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(std::min(width, widest))));
    ends.push_back(std::min(end, samples));
  }
  return ends;
}

// The mean of exp(−x u) over 0 ≤ u ≤ 1.
double mean_decay(double x) { return -std::expm1(-x) / x; }

}  // namespace

BaselineBlocks baseline_blocks(std::size_t rest, std::size_t moving, double fs_Hz) {
  const auto r = static_cast<double>(rest), m = static_cast<double>(moving);
  const std::vector<std::size_t> before = block_ends(rest, r / kNarrowestPerRest, r / kWidestPerRest);
  const std::vector<std::size_t> after = block_ends(moving, m / kNarrowestPerMotion, m / kWidestPerMotion);
  BaselineBlocks blocks{.begin_s = {}, .end_s = {}, .first = {0}, .at_rest = before.size()};
  for (std::size_t i = before.size(); i-- > 0;) blocks.first.push_back(rest - (i > 0 ? before[i - 1] : 0));
  for (const std::size_t end : after) blocks.first.push_back(rest + end);
  for (std::size_t b = 0; b + 1 < blocks.first.size(); ++b) {
    blocks.begin_s.push_back((static_cast<double>(blocks.first[b]) - r) / fs_Hz);
    blocks.end_s.push_back((static_cast<double>(blocks.first[b + 1]) - r) / fs_Hz);
  }
  return blocks;
}

Eigen::MatrixXd flicker_covariance(const BaselineBlocks& blocks, double fs_Hz) {
  const auto count = static_cast<Eigen::Index>(blocks.size());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  const double length_s = blocks.end_s.back() - blocks.begin_s.front();
  std::vector<double> mean(blocks.size());
  for (double rate = kSlowest / length_s; rate < std::numbers::pi * fs_Hz; rate *= 2) {  // (1)
    for (std::size_t b = 0; b < blocks.size(); ++b) mean[b] = mean_decay(rate * (blocks.end_s[b] - blocks.begin_s[b]));
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const auto row = static_cast<Eigen::Index>(b);
      covariance(row, row) += 2 / (rate * (blocks.end_s[b] - blocks.begin_s[b])) * (1 - mean[b]);
      for (std::size_t c = b + 1; c < blocks.size(); ++c) {
        covariance(row, static_cast<Eigen::Index>(c)) +=
            std::exp(-rate * (blocks.begin_s[c] - blocks.end_s[b])) * mean[b] * mean[c];
      }
    }
  }
  covariance *= std::numbers::ln2;
  return covariance.selfadjointView<Eigen::Upper>();
}

Eigen::VectorXd deflection_by_block(const BaselineBlocks& blocks, double t_s, double highpass_corner_Hz) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(blocks.size()));
  const auto by_constant = [&](double since_s) {
    return since_s * since_s / 2 + kTwoPi * highpass_corner_Hz * since_s * since_s * since_s / 6;
  };
  for (std::size_t b = blocks.at_rest; b < blocks.size() && blocks.begin_s[b] < t_s; ++b)
    out(static_cast<Eigen::Index>(b)) =
        by_constant(t_s - blocks.begin_s[b]) - by_constant(std::max(0.0, t_s - blocks.end_s[b]));
  return out;
}

}  // namespace percuss::metrics
