#include "identify/decay/decay_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr Index kBlock = 256;         // lines of a block: wider than the resonances of close modes
constexpr Index kFirstBlock = 32;     // lines of the block at frequency zero
constexpr Index kMinBlocks = 8;       // shorter spectra have smaller blocks
constexpr double kResolution = 1e-5;  // of the RMS: less than recorders' noise, more than six digits' rounding

// The median of a mean of `hits` exponential variables, over its expectation (Wilson and Hilferty).
double median_of_mean(double hits) { return hits == 1 ? std::log(2.0) : std::pow(1 - 1 / (9 * hits), 3); }

// Blocks of lines, and where their centres lie. A mode's width, and the range over which the level of the noise
// changes, grow in proportion to the frequency: the blocks at low lines are smaller.
class Blocks {
 public:
  explicit Blocks(Index lines) {
    const Index largest = std::clamp<Index>(lines / kMinBlocks, std::min<Index>(16, lines), kBlock);
    Index first = 0;
    while (first < lines) {
      const Index size = std::min(largest, std::max(kFirstBlock, first));
      first_.push_back(first);
      first = std::min(first + size, lines);
    }
    first_.push_back(lines);
  }
  std::size_t count() const { return first_.size() - 1; }
  Index first(std::size_t block) const { return first_[block]; }
  Index length(std::size_t block) const { return first_[block + 1] - first_[block]; }
  double centre(std::size_t block) const {
    return static_cast<double>(first(block)) + static_cast<double>(length(block) - 1) / 2;
  }

 private:
  std::vector<Index> first_;  // [blocks + 1]; last: the number of lines
};

// The logarithm of the mean power in each block, from the median of the lines. `averages`: exponential variables in a
// line's power.
std::vector<double> block_levels(const Eigen::VectorXd& power, const Blocks& blocks, double averages, double floor) {
  std::vector<double> out;
  for (std::size_t b = 0; b < blocks.count(); ++b) {
    const double* const first = power.data() + blocks.first(b);
    const std::vector<double> values(first, first + blocks.length(b));
    out.push_back(std::log(std::max({median(values) / median_of_mean(averages), floor, 1e-290})));
  }
  return out;
}

// The level of each hit, as a factor of the power. In each block, the hit's level is divided by the median level of all
// hits. The result is the median of these ratios over the blocks.
std::vector<double> hit_levels(const std::vector<std::vector<double>>& levels) {
  const std::size_t hits = levels.size(), blocks = levels.front().size();
  std::vector<std::vector<double>> above(hits);
  for (std::size_t b = 0; b < blocks; ++b) {
    std::vector<double> of_block;
    for (std::size_t h = 0; h < hits; ++h) of_block.push_back(levels[h][b]);
    const double typical = median(of_block);
    for (std::size_t h = 0; h < hits; ++h) above[h].push_back(levels[h][b] - typical);
  }
  std::vector<double> out;
  for (const std::vector<double>& one : above) out.push_back(std::exp(median(one)));
  return out;
}

}  // namespace

Eigen::MatrixXd decay_line_noise(const DecaySpectra& residual, const Eigen::VectorXd& floor) {
  const auto channels = static_cast<Index>(residual.channels), hits = static_cast<Index>(residual.hits);
  const Index lines = residual.lines.rows();
  const Blocks blocks(lines);
  Eigen::MatrixXd out(lines, residual.lines.cols());
  for (Index c = 0; c < channels; ++c) {
    std::vector<std::vector<double>> levels;
    for (Index h = 0; h < hits && hits > 1; ++h) {
      const Index i = h * channels + c;
      levels.push_back(block_levels(residual.lines.col(i).cwiseAbs2(), blocks, 1, floor(i)));
    }
    const std::vector<double> of_hit = hits > 1 ? hit_levels(levels) : std::vector<double>{1};
    Eigen::VectorXd power = Eigen::VectorXd::Zero(lines);
    double lowest = 0;  // limit of the power: the largest (rounding power / level) of all hits
    for (Index h = 0; h < hits; ++h) {
      const Index i = h * channels + c;
      const double level = of_hit[static_cast<std::size_t>(h)];
      power += residual.lines.col(i).cwiseAbs2() / level / static_cast<double>(hits);
      lowest = std::max(lowest, floor(i) / level);
    }
    const std::vector<double> level = block_levels(power, blocks, static_cast<double>(hits), lowest);
    std::size_t b = 0;
    for (Index k = 0; k < lines; ++k) {
      const auto at = static_cast<double>(k);
      while (b + 2 < blocks.count() && at > blocks.centre(b + 1)) ++b;
      const bool alone = level.size() < 2;
      const double width = alone ? 1 : blocks.centre(b + 1) - blocks.centre(b);
      const double part = alone ? 0 : std::clamp((at - blocks.centre(b)) / width, 0.0, 1.0);
      const double value = std::exp(alone ? level[0] : (1 - part) * level[b] + part * level[b + 1]);
      for (Index h = 0; h < hits; ++h) out(k, h * channels + c) = of_hit[static_cast<std::size_t>(h)] * value;
    }
  }
  return out;
}

Eigen::VectorXd decay_rounding(const DecaySpectra& measured) {
  return kResolution * kResolution / static_cast<double>(measured.lines.rows()) *
         measured.lines.colwise().squaredNorm().transpose();
}

Eigen::VectorXd smooth_noise_std(const Eigen::MatrixXd& noise) {
  const Index lines = noise.rows();
  const Eigen::VectorXd log_std = noise.array().log().rowwise().mean() / 2;
  std::vector<double> sum{0};
  for (Index k = 0; k < lines; ++k) sum.push_back(sum.back() + log_std(k));
  Eigen::VectorXd out(lines);
  for (Index k = 0; k < lines; ++k) {
    // Half an octave to either side.
    const auto first = static_cast<Index>(static_cast<double>(k) / std::numbers::sqrt2);
    const Index last = std::min(lines - 1, static_cast<Index>(static_cast<double>(k) * std::numbers::sqrt2));
    const double mean = (sum[static_cast<std::size_t>(last + 1)] - sum[static_cast<std::size_t>(first)]) /
                        static_cast<double>(last + 1 - first);
    out(k) = std::exp(mean - sum.back() / static_cast<double>(lines));
  }
  return out;
}

}  // namespace percuss::identify
