#include "identify/fit/local_fit.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/math/linear_algebra.hpp"
#include "core/units.hpp"
#include "identify/fit/pole_update.hpp"
#include "identify/fit/variable_projection.hpp"
#include "identify/noise/window_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kUndamped = 1e-4;

struct Reached {
  ProjectedState state;
  MatrixXd curvature;  // matrix of its normal equations
};

// Levenberg–Marquardt.
Reached descend(const VariableProjection& projection, LocalFit& fit, const LocalFitOptions& options) {
  const std::size_t modes = fit.poles.size();
  ProjectedState state = projection.evaluate(fit.poles);
  auto [a, b] = projection.normal_equations(state, modes);
  double lambda = kUndamped;
  for (int step = 0; step < options.max_steps && !fit.converged; ++step) {
    bool better = false;
    for (int attempt = 0; attempt < 12 && !better; ++attempt) {
      const VectorXd move = solve_gram(a, b, lambda);
      const double share = state.cost / static_cast<double>(std::max<std::size_t>(fit.degrees, 1));
      fit.converged = lambda <= kUndamped && move.dot(b) < options.change * options.change * share;
      if (fit.converged) break;
      const double size = normalised_step(move, fit.poles);
      const auto poles = updated_poles(fit.poles, move);
      if (!std::isfinite(size) || size > 1e3 || !poles_in_bounds(poles)) {
        lambda = std::max(lambda * 10, 1e-3);
        continue;
      }
      ProjectedState next = projection.evaluate(poles);
      better = next.cost <= state.cost;
      if (!better && size < options.tolerance) break;  // as far as rounding lets it go
      lambda = better ? lambda * 0.2 : lambda * 10;
      if (!better) continue;
      fit.converged = size < options.tolerance;
      fit.poles = poles;
      state = std::move(next);
      std::tie(a, b) = projection.normal_equations(state, modes);
    }
    if (!better) break;
  }
  return {.state = std::move(state), .curvature = std::move(a)};
}

void add_uncertainty(LocalFit& fit, const VariableProjection& projection, const Reached& reached,
                     const VectorXd& weight, const WindowNoise& window) {
  const auto& [state, curvature] = reached;
  const std::size_t modes = fit.poles.size();
  // Complex data: |residual|² per line is twice the variance of each real part, and so are the weights' squares.
  const double scale = fit.degrees > 0 ? state.cost / static_cast<double>(fit.degrees) : 1;
  const MatrixXd covariance = inverse_gram(curvature) * scale;
  for (Index m = 0; m < static_cast<Index>(modes); ++m) {
    const double common = window.of_pole(fit.poles[static_cast<std::size_t>(m)]);
    fit.freq_std_Hz(m) = std::sqrt(std::max(0.0, common * covariance(2 * m, 2 * m)));
    fit.damping_std(m) = std::sqrt(std::max(0.0, common * covariance(2 * m + 1, 2 * m + 1)));
  }
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      const auto o = static_cast<Index>(part.outputs[i]);
      const auto column = static_cast<Index>(i);
      // What a moved pole does to the amplitudes.
      const MatrixXcd moves = projection.residue_moves(part, column);
      for (Index m = 0; m < static_cast<Index>(modes); ++m) {
        fit.residues(o, m) = part.amplitude(m, column);
        const double linear = part.inverse_gram(m, m).real() * weight(o) * weight(o) * scale;  // of each real part
        const double from_poles = (moves.row(m) * covariance.cast<Complex>() * moves.row(m).adjoint())(0).real();
        const Pole& pole = fit.poles[static_cast<std::size_t>(m)];
        fit.residue_std(o, m) =
            std::sqrt(std::max(0.0, window.of_residue(pole) * linear + 0.5 * window.of_pole(pole) * from_poles));
      }
      const auto residual = part.residual.col(column);
      const double freedom = std::max(1.0, static_cast<double>(residual.size() - static_cast<Index>(modes) - 2));
      fit.noise(o) = std::sqrt(residual.squaredNorm() / freedom);
    }
  }
}

}  // namespace

LocalFit fit_locally(const FrfDataset& set, const std::vector<VectorXcd>& data, const VectorXd& weight,
                     std::vector<Pole> start, const LocalFitOptions& options) {
  const auto outputs = static_cast<Index>(set.outputs.size());
  const auto modes = static_cast<Index>(start.size());
  LocalFit fit{.poles = std::move(start),
               .residues = MatrixXcd::Zero(outputs, modes),
               .residue_std = MatrixXd::Zero(outputs, modes),
               .freq_std_Hz = VectorXd::Zero(modes),
               .damping_std = VectorXd::Zero(modes),
               .noise = VectorXd::Zero(outputs)};
  const VariableProjection projection(set, data, weight, options.first, options.count, options.residual_terms);
  const auto unknowns = 2 * fit.poles.size() + 2 * set.outputs.size() * (fit.poles.size() + options.residual_terms);
  const std::size_t values = 2 * set.outputs.size() * options.count;
  fit.degrees = values > unknowns ? values - unknowns : 0;
  const Reached reached = descend(projection, fit, options);
  fit.cost = reached.state.cost;
  add_uncertainty(fit, projection, reached, weight, WindowNoise(set));
  return fit;
}

Pole pole_of_window(const FrfDataset& set, const std::vector<VectorXcd>& data, std::size_t first) {
  // Per output the unknowns a, b are projected out; what is left is one complex unknown s.
  Complex numerator;
  double denominator = 0;
  const Index size = data.front().size(), half = size / 2;
  const MatrixXd q = orthonormal_polynomials(size, 2);
  VectorXcd jw(size);
  for (Index i = 0; i < size; ++i) jw(i) = Complex(0, kTwoPi * set.lines.df_Hz() * static_cast<double>(i - half));
  for (const VectorXcd& h : data) {
    const VectorXcd shifted = jw.cwiseProduct(h);
    const VectorXcd left = shifted - q * (q.transpose() * shifted);
    const VectorXcd right = h - q * (q.transpose() * h);
    numerator += right.dot(left);
    denominator += right.squaredNorm();
  }
  if (!(denominator > 0)) return {};
  const double middle = kTwoPi * set.lines.freq_Hz(first + static_cast<std::size_t>(half));
  const Complex s = numerator / denominator + Complex(0, middle);
  if (!(s.real() < 0) || !(s.imag() > 0)) return {};
  const double omega = std::abs(s);
  return {.freq_Hz = omega / kTwoPi, .damping_ratio = std::min(-s.real() / omega, 0.99 * kMaxFittedDamping)};
}

}  // namespace percuss::identify
