#include "identify/noise/force_noise.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/complex.hpp"
#include "core/math/wide_loops.hpp"
#include "core/units.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

// Spacing of the groups of samples (Delay), in periods of the highest line, but at least one sample. The noise divides
// equally between real and imaginary part if the squares of the groups' phase factors sum to zero. From one group to
// the next, this square turns by 2 · 2π · kDelay = 4 rad. This is less than a full turn, so the squares of the groups
// cancel like the squares of single samples. With a spacing of one sample, each group is one sample.
constexpr double kDelay = 0.32;

constexpr double kEqualParts = 0.01;  // difference of the variances of real and imaginary part, over their sum

constexpr double kNarrow = 0.2;  // half of a band's width over its highest line
constexpr double kMinGroups = 16;

// Standard deviation of the sum of the ringing that the gate cuts off, in standard deviations σ of the noise. The gate
// ends where the ringing is below 4 σ. The ringing roughly alternates in sign from sample to sample, so that at low
// frequencies its sum is half its first sample. Near half the sampling rate the sum is larger, by the factor
// kMaxRingingGain at most.
constexpr double kCutRinging = 1;
constexpr double kMaxRingingGain = 5;

// Samples of the gate that carry noise into the force, averaged over the hits.
double gated_samples(const PointForce& force) {
  double gated = 0;
  for (const frf::ForceBlock& block : force.blocks)
    gated += static_cast<double>(std::max(block.force_N.size(), block.ungated_N.size()));
  return gated / static_cast<double>(force.blocks.size());
}

// Centre of the pulse within its gate, in samples.
double centre_of(const frf::ForceBlock& block) {
  const auto& f = block.force_N;
  double moment = 0, sum = 0;
  for (std::size_t n = 0; n < f.size(); ++n) {
    moment += static_cast<double>(n) * f[n] * f[n];
    sum += f[n] * f[n];
  }
  return sum > 0 ? moment / sum : 0;
}

// A group of samples that counts as one: its delay from the pulse's centre, and its variance over the variance of one
// sample.
struct Delay {
  double samples, variance;
};

// The gate, divided into groups of samples.
std::vector<Delay> delays_of(const PointForce& force, double groups) {
  const double step = gated_samples(force) / groups;
  const double centre = centre_of(force.blocks.front());
  std::vector<Delay> delays;
  delays.reserve(static_cast<std::size_t>(groups));
  for (double i = 0; i < groups; ++i) delays.push_back({(i + 0.5) * step - 0.5 - centre, step});
  return delays;
}

// Standard deviation of the ringing cut off on one side of the gate, N. It is the same in all hits, so the hits do not
// average it out: hence the factor √hits.
double cut_ringing_N(const PointForce& force, double turns) {
  if (!force.blocks.front().ungated_N.empty()) return 0;
  const double gain = 1 / std::max(std::cos(0.5 * kTwoPi * turns), 1 / kMaxRingingGain);
  return kCutRinging * force.noise_N * gain * std::sqrt(static_cast<double>(force.blocks.size()));
}

// Variance of the real part of the error that the noise of the gate causes, over the variance of the whole error: the
// mean of cos² over the samples' phases, which count from the pulse's centre.
double real_share(const PointForce& force, double samples, double turns) {
  const double angle = kTwoPi * turns;
  const double inequality = std::sin(angle * samples) / (samples * std::sin(angle));
  if (!(std::abs(inequality) > kEqualParts)) return 0.5;
  return 0.5 * std::max(0.0, 1 + inequality * std::cos(angle * (samples - 1 - 2 * centre_of(force.blocks.front()))));
}

double one_over_force(const PointForce& force, std::size_t line) {
  return 1 / std::sqrt(std::max(force.ff[line], 1e-300));
}

PERCUSS_WIDE_LOOPS void multiply(std::vector<Complex>& values, const std::vector<Complex>& factors) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = times(values[k], factors[k]);
}

// [lines, delays + 2] relative error of the force's spectrum from the noise around each delay and from the ringing cut
// off on either side.
Eigen::MatrixXcd relative_force_errors(const FrfDataset& set, const PointForce& force,
                                       const std::vector<std::size_t>& lines, const std::vector<Delay>& delays) {
  const auto count = static_cast<Index>(delays.size());
  Eigen::MatrixXcd errors(static_cast<Index>(lines.size()), count + 2);
  const double apart = delays[1].samples - delays[0].samples;
  const double begin = -1 - centre_of(force.blocks.front());
  std::vector<Complex> error(lines.size()), turn(lines.size());
  for (Index k = 0; k < errors.rows(); ++k) {
    const std::size_t line = lines[static_cast<std::size_t>(k)];
    const double turns = set.lines.freq_Hz(line) / set.lines.fs_Hz;
    const double per_N = one_over_force(force, line);
    turn[static_cast<std::size_t>(k)] = std::polar(1.0, -kTwoPi * turns * apart);
    error[static_cast<std::size_t>(k)] = std::polar(per_N * force.noise_N * std::sqrt(delays.front().variance),
                                                    -kTwoPi * turns * delays.front().samples);
    const double cut = per_N * cut_ringing_N(force, turns);
    errors(k, count) = std::polar(cut, -kTwoPi * turns * begin);
    errors(k, count + 1) = std::polar(cut, -kTwoPi * turns * (begin + 1 + gated_samples(force)));
  }
  for (Index i = 0; i < count; ++i) {
    std::copy(error.begin(), error.end(), errors.col(i).data());
    multiply(error, turn);
  }
  return errors;
}

}  // namespace

Eigen::MatrixXcd gain_errors(const FrfDataset& set, std::size_t point, const std::vector<std::size_t>& lines,
                             ForceErrors of) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty() || !(force.noise_N > 0) || lines.empty()) return {};
  const double gated = gated_samples(force);
  const double highest = set.lines.freq_Hz(lines.back()) / set.lines.fs_Hz;
  const double half = 0.5 * (highest - set.lines.freq_Hz(lines.front()) / set.lines.fs_Hz);
  if (half >= kNarrow * highest) {
    const double apart = std::max(1.0, kDelay / highest);
    const auto delays = delays_of(force, std::max(2.0, std::ceil(gated / apart)));
    const Eigen::MatrixXcd errors = relative_force_errors(set, force, lines, delays);
    return of == ForceErrors::all ? errors : errors.leftCols(static_cast<Index>(delays.size()));
  }
  // A narrow band allows groups of many periods, each with an in-phase and a quadrature variable.
  const double groups = std::max(kMinGroups, std::ceil(gated * half / kDelay));
  Eigen::MatrixXcd in_phase = relative_force_errors(set, force, lines, delays_of(force, groups));
  if (of == ForceErrors::noise) in_phase = in_phase.leftCols(in_phase.cols() - 2).eval();
  Eigen::MatrixXcd errors(in_phase.rows(), 2 * in_phase.cols());
  errors << std::sqrt(0.5) * in_phase, Complex(0, std::sqrt(0.5)) * in_phase;
  return errors;
}

double gain_std(const FrfDataset& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // the force is unknown
  const std::size_t line = set.lines.nearest(freq_Hz);
  const double cut_N = cut_ringing_N(force, set.lines.freq_Hz(line) / set.lines.fs_Hz);
  const double of_gate_N = force.noise_N * std::sqrt(gated_samples(force));
  return one_over_force(force, line) * std::sqrt(0.5) * std::hypot(of_gate_N, cut_N, cut_N);
}

double gain_amplitude_std(const FrfDataset& set, std::size_t point, double freq_Hz) {
  const PointForce& force = set.points[point];
  if (force.blocks.empty() || force.ff.empty()) return 0;  // the force is unknown
  const double samples = gated_samples(force);
  const double turns = set.lines.freq_Hz(set.lines.nearest(freq_Hz)) / set.lines.fs_Hz;
  return gain_std(set, point, freq_Hz) * std::sqrt(2 * real_share(force, samples, turns));
}

}  // namespace percuss::identify
