#include "identify/fit/local_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math/levenberg_marquardt.hpp"
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

constexpr LevenbergMarquardtOptions kLocalSearch{.max_rejections = 12,
                                                 .initial_damping = 1e-4,
                                                 .damping_decrease = 0.2,
                                                 .min_damping_outside = 1e-3,
                                                 .max_step_size = 1e3};

// The poles of a window are the unknowns; residues and polynomial follow from them.
class LocalProblem : public LeastSquaresProblem {
 public:
  LocalProblem(const VariableProjection& projection, std::vector<Pole> poles)
      : projection_(projection), poles_(std::move(poles)), state_(projection.evaluate(poles_)) {}

  double cost() const override { return state_.cost; }
  const NormalEquations& normal_equations() override {
    if (!normal_) normal_ = projection_.normal_equations(state_, poles_.size());
    return *normal_;
  }
  double step_size(const VectorXd& step) const override { return normalised_step(step, poles_); }
  std::optional<double> try_step(const VectorXd& step) override {
    trial_poles_ = updated_poles(poles_, step);
    if (!poles_in_bounds(trial_poles_)) return std::nullopt;
    trial_ = projection_.evaluate(trial_poles_);
    return trial_.cost;
  }
  void accept() override {
    poles_ = std::move(trial_poles_);
    state_ = std::move(trial_);
    normal_.reset();
  }

  const std::vector<Pole>& poles() const { return poles_; }
  const ProjectedState& state() const { return state_; }

 private:
  const VariableProjection& projection_;
  std::vector<Pole> poles_, trial_poles_;
  ProjectedState state_, trial_;
  std::optional<NormalEquations> normal_;
};

// Whether the poles converged. Stricter than LevenbergMarquardtSummary::converged(): a small step that raises the cost
// (rounding_limit) is not enough.
bool descend(LocalProblem& problem, const LocalFitOptions& options, std::size_t degrees) {
  LevenbergMarquardtOptions search = kLocalSearch;
  search.max_steps = options.max_steps;
  search.step_tolerance = options.tolerance;
  search.cost_tolerance =
      options.change_tolerance * options.change_tolerance / static_cast<double>(std::max<std::size_t>(degrees, 1));
  const LevenbergMarquardtStop stop = levenberg_marquardt(problem, search).stop;
  return stop == LevenbergMarquardtStop::small_step || stop == LevenbergMarquardtStop::small_decrease;
}

void add_uncertainty(LocalFit& fit, const VariableProjection& projection, LocalProblem& problem,
                     const VectorXd& noise_scale, const LocalFitOptions& options, const WindowNoise& window) {
  const ProjectedState& state = problem.state();
  const std::size_t modes = fit.poles.size();
  // |residual|² per line is the sum of two equal variances, of real and imaginary part, and so is noise_scale².
  const double scale = fit.degrees > 0 ? state.cost / static_cast<double>(fit.degrees) : 1;
  const MatrixXd covariance = inverse_gram(problem.normal_equations().matrix) * scale;
  for (Index m = 0; m < static_cast<Index>(modes); ++m) {
    const double common = window.of_pole(fit.poles[static_cast<std::size_t>(m)]);
    fit.freq_std_Hz(m) = std::sqrt(std::max(0.0, common * covariance(2 * m, 2 * m)));
    fit.damping_std(m) = std::sqrt(std::max(0.0, common * covariance(2 * m + 1, 2 * m + 1)));
  }
  for (const ProjectedPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto o = static_cast<Index>(part.channels[i]);
      const auto column = static_cast<Index>(i);
      // Derivatives of the amplitudes by the poles.
      const MatrixXcd derivatives = projection.residue_derivatives(part, column);
      for (Index m = 0; m < static_cast<Index>(modes); ++m) {
        fit.residues(o, m) = part.amplitude(m, column);
        const double linear =
            part.inverse_gram(m, m).real() * noise_scale(o) * noise_scale(o) * scale;  // variance of the real part
        const double from_poles =
            (derivatives.row(m) * covariance.cast<Complex>() * derivatives.row(m).adjoint())(0).real();
        const Pole& pole = fit.poles[static_cast<std::size_t>(m)];
        fit.residue_std(o, m) = std::sqrt(
            std::max(0.0, window.of_residue(pole) * linear + 0.5 * window.of_residue_by_pole(pole) * from_poles));
      }
      const auto residual = part.residual.col(column);
      const auto eliminated = static_cast<Index>(modes + options.residual_terms);
      const double freedom = std::max(1.0, static_cast<double>(residual.size() - eliminated));
      fit.noise(o) = std::sqrt(residual.squaredNorm() / freedom);
    }
  }
}

}  // namespace

LocalFit fit_locally(const FrfDataset& set, const std::vector<VectorXcd>& data, const VectorXd& noise_scale,
                     std::vector<Pole> start, const LocalFitOptions& options) {
  const auto channels = static_cast<Index>(set.channels.size());
  const auto modes = static_cast<Index>(start.size());
  LocalFit fit{.poles = std::move(start),
               .residues = MatrixXcd::Zero(channels, modes),
               .residue_std = MatrixXd::Zero(channels, modes),
               .freq_std_Hz = VectorXd::Zero(modes),
               .damping_std = VectorXd::Zero(modes),
               .noise = VectorXd::Zero(channels)};
  const VariableProjection projection(set, data, noise_scale, options.first, options.count, options.residual_terms);
  const auto unknowns = 2 * fit.poles.size() + 2 * set.channels.size() * (fit.poles.size() + options.residual_terms);
  const std::size_t values = 2 * set.channels.size() * options.count;
  fit.degrees = values > unknowns ? values - unknowns : 0;
  LocalProblem problem(projection, std::move(fit.poles));
  fit.converged = descend(problem, options, fit.degrees);
  fit.poles = problem.poles();
  fit.cost = problem.cost();
  add_uncertainty(fit, projection, problem, noise_scale, options, WindowNoise(set));
  return fit;
}

Pole pole_of_window(const FrfDataset& set, const std::vector<VectorXcd>& data, std::size_t first) {
  // Projecting out a and b of each FRF leaves one complex unknown, s.
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
