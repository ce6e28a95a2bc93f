#include "identify/decay/decay_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/statistics.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr Index kBlock = 256, kMinBlocks = 8;  // lines: wider than the resonances of close modes
constexpr double kColumnAccuracy = 1e-10;      // of a column of the model, relative

// The median of a mean of `hits` exponential variables, over its expectation (Wilson and Hilferty).
double median_of_mean(double hits) { return hits == 1 ? std::log(2.0) : std::pow(1 - 1 / (9 * hits), 3); }

}  // namespace

Eigen::MatrixXd decay_line_noise(const DecaySpectra& residual, const Eigen::VectorXd& floor) {
  const Index lines = residual.lines.rows();
  const auto channels = static_cast<Index>(residual.channels), hits = static_cast<Index>(residual.hits);
  const Index block = std::clamp<Index>(lines / kMinBlocks, std::min<Index>(16, lines), kBlock);
  const Index blocks = (lines + block - 1) / block;
  Eigen::MatrixXd out(lines, channels);
  for (Index c = 0; c < channels; ++c) {
    Eigen::VectorXd power = Eigen::VectorXd::Zero(lines);
    for (Index h = 0; h < hits; ++h)
      power += residual.lines.col(h * channels + c).cwiseAbs2() / static_cast<double>(hits);
    std::vector<double> level, centre;
    for (Index b = 0; b < blocks; ++b) {
      const Index first = b * block, count = std::min(block, lines - first);
      const std::vector<double> values(power.data() + first, power.data() + first + count);
      const double mean = median(values) / median_of_mean(static_cast<double>(hits));
      level.push_back(std::log(std::max({mean, floor(c), 1e-290})));
      centre.push_back(static_cast<double>(first) + static_cast<double>(count - 1) / 2);
    }
    std::size_t b = 0;
    for (Index k = 0; k < lines; ++k) {
      const auto at = static_cast<double>(k);
      while (b + 2 < centre.size() && at > centre[b + 1]) ++b;
      const double part = centre.size() < 2 ? 0 : std::clamp((at - centre[b]) / (centre[b + 1] - centre[b]), 0.0, 1.0);
      out(k, c) = std::exp(centre.size() < 2 ? level[0] : (1 - part) * level[b] + part * level[b + 1]);
    }
  }
  return out;
}

Eigen::VectorXd decay_rounding(const DecaySpectra& measured) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Index>(measured.channels));
  for (Index i = 0; i < measured.lines.cols(); ++i) {
    out(i % out.size()) += kColumnAccuracy * kColumnAccuracy * measured.lines.col(i).squaredNorm() /
                           static_cast<double>(measured.lines.rows()) / static_cast<double>(measured.hits);
  }
  return out;
}

}  // namespace percuss::identify
