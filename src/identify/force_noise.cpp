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

constexpr double kNarrow = 0.2;  // half of a band over its highest line
constexpr double kLeastStretches = 16;

// Deviations of the noise: ringing of up to four is cut off where the gate ends. It changes its sign from sample to
// sample, so that in the band all of it acts as half its first one.
constexpr double kCutRinging = 1;

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

// A stretch of samples as one: where it lies from the pulse's centre, and how often a sample's variance.
struct Delay {
  double samples, variance;
};

// Variance of the ringing that the gate cuts off on one side, the same in all hits; in units of a sample's.
double cut_ringing(const PointForce& force) {
  const bool gated = force.blocks.front().whole_N.empty();
  return gated ? kCutRinging * kCutRinging * static_cast<double>(force.blocks.size()) : 0;
}

// The gate in so many stretches, and what it cuts off on either side.
std::vector<Delay> delays_of(const PointForce& force, double stretches) {
  const double gated = gated_samples(force);
  const double centre = centre_of(force.blocks.front());
  const double step = gated / stretches;
  std::vector<Delay> delays;
  delays.reserve(static_cast<std::size_t>(stretches) + 2);
  for (double i = 0; i < stretches; ++i) delays.push_back({(i + 0.5) * step - 0.5 - centre, step});
  delays.push_back({-1 - centre, cut_ringing(force)});
  delays.push_back({gated - centre, cut_ringing(force)});
  return delays;
}

// [lines, delays] what the noise around each delay makes of the force, over the force.
Eigen::MatrixXcd over_force(const FrfSet& set, const PointForce& force, const std::vector<std::size_t>& lines,
                            const std::vector<Delay>& delays) {
  Eigen::MatrixXcd errors(static_cast<Index>(lines.size()), static_cast<Index>(delays.size()));
  const double apart = delays[1].samples - delays[0].samples;
  for (Index k = 0; k < errors.rows(); ++k) {
    const std::size_t line = lines[static_cast<std::size_t>(k)];
    const double turn = -kTwoPi * set.lines.freq_Hz(line) / set.lines.fs_Hz;
    const double size = force.noise_N / std::sqrt(std::max(force.ff[line], 1e-300));
    const Complex from_one_to_next = std::polar(1.0, turn * apart);
    Complex phase = std::polar(size, turn * delays.front().samples);
    for (std::size_t i = 0; i < delays.size(); ++i) {
      const bool evenly = i == 0 || std::abs(delays[i].samples - delays[i - 1].samples - apart) < 1e-6;
      if (!evenly) phase = std::polar(size, turn * delays[i].samples);
      errors(k, static_cast<Index>(i)) = phase * std::sqrt(delays[i].variance);
      phase *= from_one_to_next;
    }
  }
  return errors;
}

}  // namespace

Eigen::MatrixXcd gain_errors(const FrfSet& set, std::size_t point, const std::vector<std::size_t>& lines) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || !(force.noise_N > 0) || lines.empty()) return {};
  const double gated = gated_samples(force);
  const double highest = set.lines.freq_Hz(lines.back()) / set.lines.fs_Hz;
  const double half = 0.5 * (highest - set.lines.freq_Hz(lines.front()) / set.lines.fs_Hz);
  if (half >= kNarrow * highest) {
    const double apart = std::max(1.0, kDelay / highest);
    return over_force(set, force, lines, delays_of(force, std::max(2.0, std::ceil(gated / apart))));
  }
  // Over few lines stretches of many periods do, each with a variable in phase and one in quadrature.
  const double stretches = std::max(kLeastStretches, std::ceil(gated * half / kDelay));
  const Eigen::MatrixXcd in_phase = over_force(set, force, lines, delays_of(force, stretches));
  Eigen::MatrixXcd errors(in_phase.rows(), 2 * in_phase.cols());
  errors << std::sqrt(0.5) * in_phase, Complex(0, std::sqrt(0.5)) * in_phase;
  return errors;
}

double gain_deviation(const FrfSet& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // nothing is known of the force
  const double variance = 0.5 * gated_samples(force) + cut_ringing(force);
  return force.noise_N * std::sqrt(variance / force.ff[set.lines.nearest(freq_Hz)]);
}

}  // namespace percuss
