#include "identify/misfit/decay_terms.hpp"

#include <array>
#include <cmath>

#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kMinGain = 14;        // F statistic of a term's two unknowns: by chance in one of a million modes
constexpr double kMinExplained = 0.5;  // of the smooth residual: else the term only follows some other misfit
constexpr double kDifference = 0.1;    // half-power bandwidths, for the second derivative

// How the pole changes during the decay: with the remaining amplitude, or with time.
enum class Term { with_amplitude, with_time };

// The column of the extra term at one point, for a residue of 1.
VectorXcd term_column(const FrfDataset& set, const ModeWindow& window, const PointForce& force, const Pole& pole,
                      Term term) {
  const auto column = [&](const Pole& at) { return mode_column(at, force, set.lines, window.first, window.count); };
  if (term == Term::with_amplitude) {
    const Pole faster{.freq_Hz = pole.freq_Hz, .damping_ratio = 2 * pole.damping_ratio};
    return column(faster).value;
  }
  const double apart_Hz = kDifference * pole.half_power_Hz();
  const Pole below{.freq_Hz = pole.freq_Hz - apart_Hz, .damping_ratio = pole.damping_ratio};
  const Pole above{.freq_Hz = pole.freq_Hz + apart_Hz, .damping_ratio = pole.damping_ratio};
  return (column(above).by_freq - column(below).by_freq) * pole.half_power_Hz();
}

// Normal equations of the poles and of one complex coefficient, whose real and imaginary part are the last unknowns.
NormalEquations with_term(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& poles,
                          const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise,
                          std::size_t mode, Term term) {
  const auto n = static_cast<Index>(2 * poles.size());
  NormalEquations normal{.matrix = MatrixXd::Zero(n + 2, n + 2), .right = VectorXd::Zero(n + 2)};
  for (const ProjectedPart& part : state.parts) {
    const PointForce& force = set.points[set.channels[part.channels.front()].point];
    ProjectedPart extra = part;
    extra.slopes.resize(part.slopes.rows(), n + 1);
    extra.slopes.leftCols(n) = part.slopes;
    extra.slopes.col(n) = term_column(set, window, force, poles[mode], term);
    const MatrixXcd slopes = projection.projected_slopes(extra);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto column = static_cast<Index>(i);
      const double w = noise(static_cast<Index>(part.channels[i]));
      MatrixXcd derivatives(slopes.rows(), n + 2);
      for (Index c = 0; c < n; ++c) derivatives.col(c) = slopes.col(c) * (part.amplitude(c / 2, column) / w);
      derivatives.col(n) = slopes.col(n) * (part.amplitude(static_cast<Index>(mode), column) / w);
      derivatives.col(n + 1) = Complex(0, 1) * derivatives.col(n);
      normal.matrix += adjoint_gram(derivatives).real();
      normal.right += adjoint_product(derivatives, part.residual.col(column) / w).real();
    }
  }
  return normal;
}

double residual_cost(const ProjectedState& state, const VectorXd& noise) {
  double cost = 0;
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i)
      cost += part.residual.col(static_cast<Index>(i)).squaredNorm() /
              std::pow(noise(static_cast<Index>(part.channels[i])), 2);
  }
  return cost;
}

// The part of the cost that differs from line to line, as noise does: from second differences of the residual.
double noise_cost(const ProjectedState& state, const VectorXd& noise) {
  double cost = 0;
  for (const ProjectedPart& part : state.parts) {
    const Index lines = part.residual.rows() - 2;
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto r = part.residual.col(static_cast<Index>(i));
      const VectorXcd rough = r.segment(1, lines) - 0.5 * (r.head(lines) + r.tail(lines));
      cost += rough.squaredNorm() / (kWhiteRoughness * std::pow(noise(static_cast<Index>(part.channels[i])), 2));
    }
  }
  return cost;
}

}  // namespace

VectorXd decay_term_shift(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& poles,
                          const VariableProjection& projection, const ProjectedState& state, const VectorXd& noise) {
  const auto n = static_cast<Index>(2 * poles.size());
  VectorXd largest = VectorXd::Zero(n);
  const double cost = residual_cost(state, noise);
  const double misfit = std::max(0.0, cost - noise_cost(state, noise));
  const double degrees = 2 * static_cast<double>(noise.size()) *
                         std::max(1.0, static_cast<double>(window.count) - static_cast<double>(poles.size()) - 3);
  for (std::size_t m = 0; m < poles.size(); ++m) {
    for (const Term term : std::array{Term::with_amplitude, Term::with_time}) {
      const NormalEquations normal = with_term(set, window, poles, projection, state, noise, m, term);
      const VectorXd all = inverse_gram(normal.matrix) * normal.right;
      const VectorXd few = inverse_gram(MatrixXd(normal.matrix.topLeftCorner(n, n))) * normal.right.head(n);
      const double gained = all.dot(normal.right) - few.dot(normal.right.head(n));
      const double left = std::max(cost - all.dot(normal.right), 1e-12 * cost);
      if (!(gained > 2 * kMinGain * left / degrees && gained > kMinExplained * misfit)) continue;
      largest = largest.cwiseMax((all.head(n) - few).cwiseAbs());
    }
  }
  return largest;
}

}  // namespace percuss::identify
