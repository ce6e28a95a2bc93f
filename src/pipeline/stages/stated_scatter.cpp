#include "pipeline/stages/stated_scatter.hpp"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

using Eigen::Index;

constexpr double kScatterReach = 3;            // half-power bandwidths on each side of a mode
constexpr double kNeighbourReach = 4;          // half-power bandwidths
constexpr std::size_t kMinReach = 8;           // lines on each side
constexpr std::size_t kMaxScatterLines = 200;  // more lines are thinned out
constexpr std::size_t kMaxNeighbours = 3;
constexpr double kSameDirection = 1e-6;
constexpr double kTiny = 1e-300;
constexpr int kPasses = 3;  // the weights follow from the fitted variances

// An FRF's part of one mode, and its change with the relative frequency of the pole at the same damping ratio.
struct ModeAtLine {
  Complex value, change;
};

ModeAtLine mode_at(const identify::Pole& pole, Complex residue, Complex s) {
  const double omega = kTwoPi * pole.freq_Hz;
  const Complex divisor = s * s + 2 * pole.damping_ratio * omega * s + omega * omega;
  const Complex value = residue * s * s / divisor;
  return {.value = value, .change = -value * (2 * pole.damping_ratio * omega * s + 2 * omega * omega) / divisor};
}

// The mode itself, then the closest others around it.
std::vector<std::size_t> modes_around(const std::vector<identify::Mode>& modes, std::size_t mode) {
  const identify::Pole& own = modes[mode].pole;
  const auto distance = [&](std::size_t m) { return std::abs(modes[m].pole.freq_Hz - own.freq_Hz); };
  std::vector<std::size_t> near;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const double reach = kNeighbourReach * std::max(own.half_power_Hz(), modes[m].pole.half_power_Hz());
    if (m == mode || distance(m) < reach) near.push_back(m);
  }
  std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(distance(a), a != mode) < std::pair(distance(b), b != mode);
  });
  near.resize(std::min(near.size(), kMaxNeighbours + 1));
  return near;
}

// [lines][parts] the products of the changes; the first is |p|². Products of p with the rest and with the constant are
// left out: beside a resonance they are the same as |p|², and far smaller.
Eigen::MatrixXd products_of(const Eigen::MatrixXcd& changes) {
  const Index count = changes.cols(), modes = count - 3;
  Eigen::MatrixXd products(changes.rows(), count * (count + 1) / 2 - 2);
  Index column = 0;
  for (Index i = 0; i < count; ++i) {
    for (Index j = i; j < (i == 0 ? 1 + modes : count); ++j)
      products.col(column++) = changes.col(i).cwiseProduct(changes.col(j).conjugate()).real();
  }
  return products;
}

// The lines around a mode; many are thinned out.
struct LinesAround {
  LinesAround(const acquire::LineRange& lines, const identify::Pole& pole) {
    const std::size_t middle = lines.nearest(pole.freq_Hz);
    const auto reach =
        std::max(kMinReach, static_cast<std::size_t>(std::ceil(kScatterReach * pole.half_power_Hz() / lines.df_Hz())));
    first = middle - std::min(middle, reach);
    const std::size_t end = std::min(lines.count, middle + reach + 1);
    step = 1 + (end - first) / kMaxScatterLines;
    rows = static_cast<Index>((end - first + step - 1) / step);
  }
  std::size_t line(Index row) const { return first + static_cast<std::size_t>(row) * step; }
  std::size_t first = 0, step = 1;
  Index rows = 0;
};

// [parts] the coefficients of the products [lines][parts] in the stated variances, by least squares.
std::vector<StatedScatter> coefficients_of(const Eigen::MatrixXd& products, const Eigen::VectorXd& stated2,
                                           double noise2) {
  const Index rows = products.rows();
  std::vector<StatedScatter> out(static_cast<std::size_t>(products.cols()));
  if (rows < products.cols() + 4) return out;
  Eigen::VectorXd model2 = stated2, found;
  for (int pass = 0; pass < kPasses; ++pass) {
    // A variance from a few hits, with the noise n² and the shared part V, scatters as n²(2V + n²).
    const Eigen::ArrayXd weight =
        1 / (noise2 * (2 * model2.array().max(noise2) - noise2) + 1e-24 * stated2.array().square()).max(kTiny).sqrt();
    Eigen::MatrixXd weighted = weight.matrix().asDiagonal() * products;
    const Eigen::RowVectorXd scale = weighted.colwise().norm().cwiseMax(kTiny);
    weighted.array().rowwise() /= scale.array();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(kSameDirection);
    solver.compute(weighted);
    const Eigen::VectorXd target = weight * stated2.array();
    found = solver.solve(target);
    model2 = ((weighted * found).array() / weight).matrix();
    if (pass + 1 < kPasses) continue;
    const double residual2 =
        (target - weighted * found).squaredNorm() / static_cast<double>(std::max<Index>(1, rows - solver.rank()));
    const Eigen::MatrixXd inverse = solver.pseudoInverse();
    for (Index i = 0; i < found.size(); ++i) {
      const StatedScatter one{.variance = found(i) / scale(i),
                              .std = std::sqrt(residual2) * inverse.row(i).norm() / scale(i)};
      if (std::isfinite(one.variance) && std::isfinite(one.std) && one.std > 0) out[static_cast<std::size_t>(i)] = one;
    }
  }
  return out;
}

}  // namespace

StatedScatter stated_pole_scatter(const identify::FrfDataset& set, const std::vector<identify::Mode>& modes,
                                  std::size_t mode, std::size_t frf, std::span<const double> std, double noise2) {
  const acquire::LineRange& lines = set.lines;
  const identify::Pole& own = modes[mode].pole;
  const std::vector<std::size_t> near = modes_around(modes, mode);
  const auto used = static_cast<Index>(near.size());
  const LinesAround around(lines, own);
  const Index rows = around.rows;
  Eigen::MatrixXcd changes = Eigen::MatrixXcd::Zero(rows, used + 3);  // the pole, the modes, the rest, a constant
  Eigen::VectorXd stated2(rows);
  for (Index row = 0; row < rows; ++row) {
    const std::size_t k = around.line(row);
    const Complex s(set.window_decay_per_s(), kTwoPi * lines.freq_Hz(k));
    Complex rest = set.channels[frf].frf[k];
    for (Index i = 0; i < used; ++i) {
      const identify::Mode& one = modes[near[static_cast<std::size_t>(i)]];
      const ModeAtLine part = mode_at(one.pole, one.residues[frf].value, s);
      changes(row, 0) += part.change;
      changes(row, 1 + i) = part.value;
      rest -= part.value;
    }
    changes(row, used + 1) = rest;
    changes(row, used + 2) = 1;
    stated2(row) = std[k] * std[k];
  }
  return coefficients_of(products_of(changes), stated2, noise2).front();
}

StatedGain stated_gain(const identify::FrfDataset& set, const identify::Mode& mode, std::size_t frf,
                       std::span<const double> std, double noise2) {
  const LinesAround lines(set.lines, mode.pole);
  Eigen::MatrixXd products(lines.rows, 4);
  Eigen::VectorXd stated2(lines.rows);
  double power = 0, power2 = 0;
  for (Index row = 0; row < lines.rows; ++row) {
    const std::size_t k = lines.line(row);
    const Complex s(set.window_decay_per_s(), kTwoPi * set.lines.freq_Hz(k));
    const Complex own = mode_at(mode.pole, mode.residues[frf].value, s).value;
    const Complex rest = set.channels[frf].frf[k] - own;
    products.row(row) << std::norm(own), std::norm(rest), (own * std::conj(rest)).real(), 1;
    stated2(row) = std[k] * std[k];
    power += std::norm(own);
    power2 += std::norm(own) * std::norm(own);
  }
  const std::vector<StatedScatter> found = coefficients_of(products, stated2, noise2);
  return {.gain = found.front(), .constant = found.back(), .constant_to_gain = power2 > 0 ? power / power2 : 0};
}

}  // namespace percuss::pipeline
