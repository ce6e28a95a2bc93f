#include "identify/force_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace percuss {
namespace {

using Eigen::Index;

// Between delays, in periods of the highest line: its square turns by four radians at the most, so that the variables'
// noise is neither more nor less real than that of all samples.
constexpr double kDelay = 0.32;

// Samples of the gate that carry noise into the force, averaged over the hits.
double gated_samples(const PointForce& force) {
  double gated = 0;
  for (const ForceBlock& block : force.blocks)
    gated += static_cast<double>(std::max(block.force_N.size(), block.whole_N.size()));
  return gated / static_cast<double>(force.blocks.size());
}

// Of the pulse within its gate, samples.
double centre_of(const ForceBlock& block) {
  const auto& f = block.force_N;
  double moment = 0, sum = 0;
  for (std::size_t n = 0; n < f.size(); ++n) {
    moment += static_cast<double>(n) * f[n] * f[n];
    sum += f[n] * f[n];
  }
  return sum > 0 ? moment / sum : 0;
}

}  // namespace

Eigen::MatrixXcd gain_errors(const FrfSet& set, std::size_t point, const std::vector<std::size_t>& lines) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || !(force.noise_N > 0) || lines.empty()) return {};
  const double gated = gated_samples(force);
  const double highest_Hz = set.lines.freq_Hz(lines.back());
  const double apart = std::max(1.0, kDelay * set.lines.fs_Hz / highest_Hz);
  const auto variables = static_cast<Index>(std::max(2.0, std::ceil(gated / apart)));
  const double step = gated / static_cast<double>(variables);
  const double scale = force.noise_N * std::sqrt(step);
  const double centre = centre_of(force.blocks.front());
  Eigen::MatrixXcd errors(static_cast<Index>(lines.size()), variables);
  for (Index k = 0; k < errors.rows(); ++k) {
    const std::size_t line = lines[static_cast<std::size_t>(k)];
    const double turn = -kTwoPi * set.lines.freq_Hz(line) / set.lines.fs_Hz;
    const double size = scale / std::sqrt(std::max(force.ff[line], 1e-300));
    const Complex from_one_to_next = std::polar(1.0, turn * step);
    Complex error = std::polar(size, turn * (0.5 * step - 0.5 - centre));
    for (Index i = 0; i < variables; ++i) {
      errors(k, i) = error;
      error *= from_one_to_next;
    }
  }
  return errors;
}

double gain_deviation(const FrfSet& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // nothing is known of the force
  return force.noise_N * std::sqrt(0.5 * gated_samples(force) / force.ff[set.lines.nearest(freq_Hz)]);
}

}  // namespace percuss
