#include "identify/fit/joint_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/fit/joint_projection.hpp"
#include "identify/fit/phase_test.hpp"
#include "identify/fit/pole_update.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSpill = 0.1;  // of the largest statistic: the misfit of its mode may cause smaller statistics
constexpr int kMaxRounds = 8;   // of releasing real residues

// rounding_tolerance: the cost of a million lines is about 10⁶, so a decrease of about 10⁻⁶ counts as rounding. The
// poles are then within about a thousandth of their standard deviation.
constexpr LevenbergMarquardtOptions kJointSearch{.max_rejections = 14,
                                                 .initial_damping = 1e-6,
                                                 .min_damping_outside = 1e-3,
                                                 .max_step_size = 1e2,
                                                 .rounding_tolerance = 1e-12};

// The poles of the state are the unknowns; residues and background follow from them.
class JointProblem : public LeastSquaresProblem {
 public:
  JointProblem(const JointProjection& projection, JointState& state, const std::vector<Pole>& held)
      : projection_(projection), state_(state), held_(held) {}

  double cost() const override { return state_.cost; }
  const NormalEquations& normal_equations() override {
    normal_ = projection_.normal_equations(state_);
    for (std::size_t m = 0; m < state_.model.poles.size(); ++m) {
      if (std::find(held_.begin(), held_.end(), state_.model.poles[m]) == held_.end()) continue;
      for (Index at = static_cast<Index>(2 * m); at < static_cast<Index>(2 * m + 2); ++at) hold(at);
    }
    return normal_;
  }
  double step_size(const VectorXd& step) const override { return normalised_step(step, state_.model.poles); }
  std::optional<double> try_step(const VectorXd& step) override {
    JointModel model = state_.model;
    model.poles = updated_poles(std::move(model.poles), step);
    if (!poles_in_bounds(model.poles)) return std::nullopt;
    trial_ = {};  // frees its matrices before the next ones are made
    trial_ = projection_.evaluate(std::move(model));
    return trial_.cost;
  }
  void accept() override { state_ = std::move(trial_); }

 private:
  // Decouples this unknown, so that its step is 0.
  void hold(Index at) {
    const double diagonal = normal_.matrix(at, at);
    normal_.matrix.row(at).setZero();
    normal_.matrix.col(at).setZero();
    normal_.matrix(at, at) = diagonal;
    normal_.right(at) = 0;
  }

  const JointProjection& projection_;
  JointState& state_;
  const std::vector<Pole>& held_;
  JointState trial_;
  NormalEquations normal_;
};

LevenbergMarquardtSummary descend(const JointProjection& projection, JointState& state,
                                  const JointFitOptions& options) {
  JointProblem problem(projection, state, options.held);
  LevenbergMarquardtOptions search = kJointSearch;
  search.max_steps = options.max_steps;
  search.step_tolerance = options.tolerance;
  search.cost_tolerance = options.cost_tolerance;
  search.max_small_decreases = options.max_small_decreases;
  return levenberg_marquardt(problem, search);
}

class JointFitter {
 public:
  // Without derivatives, only residues_at_start() with an empty covariance may be called.
  JointFitter(const FrfDataset& set, std::vector<Pole> start, const JointFitOptions& options,
              ColumnContent need = ColumnContent::derivatives)
      : set_(set), options_(options), need_(need), projection_(set, start, options.core_share) {
    const std::size_t modes = start.size();
    state_ = projection_.evaluate({.poles = std::move(start), .real = std::vector<char>(modes, 0)}, need);
  }

  JointFit run() {
    // Complex residues fit any phase: their residual gives the noise.
    const bool settled = improve_poles();
    const auto residual = projection_.unweighted_residual(state_);
    if (!settled || (options_.worth_continuing && !options_.worth_continuing(residual)))
      return {.poles = state_.model.poles, .trials = trials_};
    projection_.weight_by_residual(state_, residual);
    state_ = projection_.evaluate(state_.model);
    if (options_.test_real) choose_real();
    bool converged = improve_poles();
    if (!options_.test_real) return result(converged, covariance_of(state_));
    bool released = false;
    for (int round = 0; round < kMaxRounds && release(); ++round) {
      released = true;
      converged = improve_poles();
    }
    if (released && release_all()) converged = improve_poles();
    return result(converged, covariance_of(state_));
  }

  // `covariance` of the poles; without rows where they are exact.
  JointFit residues_at_start(const MatrixXd& covariance) {
    projection_.weight_by_residual(state_, projection_.unweighted_residual(state_));
    state_ = projection_.evaluate(state_.model, need_);
    return result(true, covariance);
  }

 private:
  // True where the poles converged.
  bool improve_poles() {
    const LevenbergMarquardtSummary summary = descend(projection_, state_, options_);
    trials_ += summary.trials;
    return summary.converged();
  }

  // Makes residues real where this gives the smaller standard deviation of the frequency.
  void choose_real() {
    const std::size_t modes = state_.model.poles.size();
    JointModel real_model = state_.model;
    real_model.real.assign(modes, 1);
    const VectorXd real = variances(projection_.evaluate(real_model));
    const VectorXd complex = variances(state_);
    for (std::size_t m = 0; m < modes; ++m) {
      const auto i = static_cast<Index>(2 * m);
      state_.model.real[m] = real(i) <= complex(i) ? 1 : 0;
    }
    state_ = projection_.evaluate(state_.model);
  }

  MatrixXd covariance_of(const JointState& state, ForceErrors of = ForceErrors::all) const {
    const MatrixXd inverse = inverse_gram(projection_.normal_equations(state).matrix);
    return inverse + inverse * projection_.force_covariance(state, of) * inverse;
  }
  // Excludes the ringing that the gate cuts off. Only its likely size is known, and a variance that includes it would
  // make undisturbed residues complex.
  VectorXd variances(const JointState& state) const { return covariance_of(state, ForceErrors::noise).diagonal(); }

  // Makes real residues complex where the phase test rejects them; true where it rejected any. The largest statistics
  // go first, because a misfit of one mode raises the statistics of others.
  bool release() {
    const MatrixXd covariance = inverse_gram(projection_.normal_equations(state_).matrix);
    std::vector<double> against(state_.model.real.size());
    for (std::size_t m = 0; m < against.size(); ++m) {
      if (state_.model.real[m]) against[m] = phase_test_statistic(projection_, state_, m, covariance);
    }
    const double most = against.empty() ? 0 : *std::max_element(against.begin(), against.end());
    if (most <= 1) return false;
    for (std::size_t m = 0; m < against.size(); ++m) {
      if (against[m] > std::max(1.0, kSpill * most)) state_.model.real[m] = 0;
    }
    state_ = projection_.evaluate(state_.model);
    return true;
  }

  // A structure with one mode of complex residues has others, whose phases may be too small for the test. True where a
  // mode had real residues.
  bool release_all() {
    std::vector<char>& real = state_.model.real;
    if (std::none_of(real.begin(), real.end(), [](char is_real) { return is_real != 0; })) return false;
    std::fill(real.begin(), real.end(), 0);
    state_ = projection_.evaluate(state_.model);
    return true;
  }

  JointFit result(bool converged, const MatrixXd& total) const {
    const auto channels = static_cast<Index>(set_.channels.size());
    const auto modes = static_cast<Index>(state_.model.poles.size());
    JointFit fit{.poles = state_.model.poles,
                 .real = state_.model.real,
                 .residues = Eigen::MatrixXcd::Zero(channels, modes),
                 .residue_std = MatrixXd::Zero(channels, modes),
                 .freq_std_Hz = VectorXd::Zero(modes),
                 .damping_std = VectorXd::Zero(modes),
                 .residual = projection_.unweighted_residual(state_),
                 .converged = converged,
                 .trials = trials_};
    for (Index m = 0; m < total.rows() / 2; ++m) {
      fit.freq_std_Hz(m) = std::sqrt(std::max(0.0, total(2 * m, 2 * m)));
      fit.damping_std(m) = std::sqrt(std::max(0.0, total(2 * m + 1, 2 * m + 1)));
    }
    for (std::size_t p = 0; p < state_.parts.size(); ++p) add_residues(fit, p, total);
    fit.residue_std = (fit.residue_std.cwiseAbs2() + projection_.residue_force_variance(state_)).cwiseSqrt();
    return fit;
  }

  void add_residues(JointFit& fit, std::size_t p, const MatrixXd& covariance) const {
    const JointPart& part = state_.parts[p];
    // Projection of the slopes on the columns.
    const bool exact = covariance.rows() == 0;
    const MatrixXd projection = exact ? MatrixXd() : part.inverse * (part.columns.transpose() * part.slopes);
    const auto unknowns = static_cast<std::size_t>(part.inverse.rows());
    parallel_for_cost(part.channels.size(), 2 * unknowns * unknowns * unknowns, [&](std::size_t i) {
      const auto o = static_cast<Index>(part.channels[i]);
      const auto column = static_cast<Index>(i);
      const double noise = projection_.noise()(o);
      MatrixXd derivatives = MatrixXd::Zero(part.inverse.rows(), covariance.rows());
      for (std::size_t m = 0; m < fit.real.size() && !exact; ++m) {
        for (Index k = 0; k < (fit.real[m] ? 1 : 2); ++k) {
          const Index at = static_cast<Index>(part.first[m]) + k;
          for (Index d = 0; d < 2; ++d)
            derivatives.col(static_cast<Index>(2 * m) + d) -= projection.col(2 * at + d) * part.amplitude(at, column);
        }
      }
      MatrixXd total = part.inverse * noise * noise;
      if (!exact) total += derivatives * covariance * derivatives.transpose();
      for (std::size_t m = 0; m < fit.real.size(); ++m) {
        const auto at = static_cast<Index>(part.first[m]);
        const auto mode = static_cast<Index>(m);
        const double imaginary = fit.real[m] ? 0 : part.amplitude(at + 1, column);
        fit.residues(o, mode) = Complex(part.amplitude(at, column), imaginary);
        const double variance = fit.real[m] ? total(at, at) : 0.5 * (total(at, at) + total(at + 1, at + 1));
        fit.residue_std(o, mode) = std::sqrt(std::max(0.0, variance));
      }
    });
  }

  const FrfDataset& set_;
  const JointFitOptions& options_;
  ColumnContent need_;
  JointProjection projection_;
  JointState state_;
  int trials_ = 0;
};

}  // namespace

JointFit fit_jointly(const FrfDataset& set, std::vector<Pole> start, const JointFitOptions& options) {
  return JointFitter(set, std::move(start), options).run();
}

JointFit fit_residues(const FrfDataset& set, const std::vector<Pole>& poles, const MatrixXd& covariance) {
  return JointFitter(set, poles, {}).residues_at_start(covariance);
}

JointFit fit_residues(const FrfDataset& set, const std::vector<Pole>& poles) {
  return JointFitter(set, poles, {}, ColumnContent::value).residues_at_start({});
}

Eigen::MatrixXcd residues_at(const FrfDataset& set, const std::vector<Pole>& poles) {
  const auto modes = static_cast<Index>(poles.size());
  const JointState state =
      JointProjection(set, poles).evaluate({.poles = poles, .real = std::vector<char>(poles.size(), 0)});
  Eigen::MatrixXcd residues(static_cast<Index>(set.channels.size()), modes);
  for (const JointPart& part : state.parts) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      for (Index m = 0; m < modes; ++m) {
        const auto first = static_cast<Index>(part.first[static_cast<std::size_t>(m)]);
        const auto amplitude = part.amplitude.col(static_cast<Index>(i));
        residues(static_cast<Index>(part.channels[i]), m) = {amplitude(first), amplitude(first + 1)};
      }
    }
  }
  return residues;
}

}  // namespace percuss::identify
