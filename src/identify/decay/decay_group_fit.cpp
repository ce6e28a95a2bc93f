#include "identify/decay/decay_group_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/levenberg_marquardt.hpp"
#include "core/math/linear_algebra.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;

constexpr double kMaxTrialDamping = 0.5;  // damping ratio beyond which a rate describes no oscillation
constexpr double kMinVariance = 1e-300;

// Real and imaginary parts one under the other.
Eigen::MatrixXd stacked(const Eigen::MatrixXcd& complex) {
  Eigen::MatrixXd out(2 * complex.rows(), complex.cols());
  out << complex.real(), complex.imag();
  return out;
}

// The linear problem at given rates, and its solution.
struct State {
  std::vector<DecayRate> rates;
  Eigen::MatrixXd q;          // [2 lines, 2 modes] orthonormal basis of the columns
  Eigen::MatrixXd r;          // [2 modes, 2 modes] upper triangular
  Eigen::MatrixXd slope;      // [2 lines, 2 modes] derivatives of the columns, with the columns projected out
  Eigen::MatrixXd amplitude;  // [2 modes, hits × channels]
  Eigen::MatrixXd residual;   // [2 lines, hits × channels]
};

// The derivatives of a mode's response by Re s and Im s, a·t·exp(st) and j·a·t·exp(st), as combinations of the mode's
// two slope columns. re and im are the parts of the amplitude a.
Eigen::Matrix2d rotation(double re, double im) { return Eigen::Matrix2d{{re, -im}, {im, re}}; }

class DecayProblem : public LeastSquaresProblem {
 public:
  DecayProblem(const DecayGroup& group, const DecaySpectra& spectra, const Eigen::MatrixXcd& data)
      : windows_(group.windows),
        spectra_(spectra),
        data_(stacked(data)),
        inverse_std_(group.line_std.cwiseInverse()),
        level_(group.level.size() == data.cols() ? group.level : Eigen::VectorXd::Ones(data.cols())),
        weight_(Eigen::VectorXd::Ones(data.cols())) {
    whiten(data_);
    solve(group.rates, now_);
  }

  const State& state() const { return now_; }
  double cost() const override { return cost_of(now_); }

  // The variance of a line's real and imaginary part, per hit and channel: one per channel from the residual, times the
  // levels of the hits. A variance per hit from its residual would give less weight to hits whose frequency differs
  // from the others', and would understate the scatter. Sets the weights.
  Eigen::VectorXd set_weights_from_residual() {
    const auto channels = static_cast<Index>(spectra_.channels), hits = static_cast<Index>(spectra_.hits);
    const auto modes = static_cast<double>(now_.rates.size());
    const double shared = 2 * modes / static_cast<double>(data_.cols());  // unknowns of the rates, per spectrum
    const double freedom = std::max(1.0, static_cast<double>(data_.rows()) - 2 * modes - shared);
    Eigen::VectorXd of_channel = Eigen::VectorXd::Zero(channels), noise(data_.cols());
    for (Index i = 0; i < data_.cols(); ++i) {
      of_channel(i % channels) += now_.residual.col(i).squaredNorm() / level_(i) / freedom / static_cast<double>(hits);
    }
    for (Index i = 0; i < data_.cols(); ++i) noise(i) = of_channel(i % channels) * level_(i);
    weight_ = noise.cwiseMax(kMinVariance).cwiseInverse();
    return noise;
  }

  const NormalEquations& normal_equations() override {
    equations_ = sum_over([](Index) { return true; });
    return equations_;
  }
  NormalEquations of_hit(std::size_t hit) const {
    const auto channels = static_cast<Index>(spectra_.channels);
    return sum_over([&](Index i) { return i / channels == static_cast<Index>(hit); });
  }

  double step_size(const Eigen::VectorXd& step) const override {
    double most = 0;
    for (Index m = 0; m < step.size() / 2; ++m) {
      const Complex s = now_.rates[static_cast<std::size_t>(m)].rate_radps;
      most = std::max(most, std::hypot(step(2 * m), step(2 * m + 1)) / std::abs(s));
    }
    return most;
  }

  std::optional<double> try_step(const Eigen::VectorXd& step) override {
    std::vector<DecayRate> rates = now_.rates;
    for (std::size_t m = 0; m < rates.size(); ++m) {
      Complex& s = rates[m].rate_radps;
      const auto at = static_cast<Index>(2 * m);
      s += Complex(step(at), step(at + 1));
      const double highest = std::numbers::pi * spectra_.fs_Hz;
      if (!(s.imag() > 0) || s.imag() > highest || -s.real() > kMaxTrialDamping * std::abs(s) ||
          s.real() * static_cast<double>(spectra_.samples) / spectra_.fs_Hz > 1)
        return std::nullopt;
    }
    solve(rates, trial_);
    return cost_of(trial_);
  }
  void accept() override { std::swap(now_, trial_); }

 private:
  double cost_of(const State& state) const { return state.residual.colwise().squaredNorm().transpose().dot(weight_); }

  // Writes a mode's columns and their derivatives, stacked, into two columns from `column` on.
  void write_columns(const DecayRate& rate, Index column, Eigen::MatrixXd& values, Eigen::MatrixXd& slopes) const {
    const Index lines = data_.rows() / 2;
    Index row = 0;
    for (const auto& [first, count] : windows_) {
      for (std::size_t at = 0; at < count; at += kDecayBlock_lines) {
        const DecayColumns part = decay_columns(rate, spectra_, first + at, std::min(kDecayBlock_lines, count - at));
        const Index rows = part.value.rows();
        values.block(row, column, rows, 2) = part.value.real();
        values.block(lines + row, column, rows, 2) = part.value.imag();
        slopes.block(row, column, rows, 2) = part.slope.real();
        slopes.block(lines + row, column, rows, 2) = part.slope.imag();
        row += rows;
      }
    }
  }

  // Divides stacked lines by the standard deviations of their noise.
  void whiten(Eigen::MatrixXd& values) const {
    if (inverse_std_.size() == 0) return;
    const Index lines = values.rows() / 2;
    values.topRows(lines).array().colwise() *= inverse_std_.array();
    values.bottomRows(lines).array().colwise() *= inverse_std_.array();
  }

  // Solves into `state`, whose matrices are used again where their sizes fit.
  void solve(const std::vector<DecayRate>& rates, State& state) {
    const auto modes = static_cast<Index>(rates.size());
    state.rates = rates;
    columns_.resize(data_.rows(), 2 * modes);
    state.slope.resize(data_.rows(), 2 * modes);
    for (Index m = 0; m < modes; ++m) write_columns(rates[static_cast<std::size_t>(m)], 2 * m, columns_, state.slope);
    whiten(columns_);
    whiten(state.slope);
    qr_.compute(columns_);
    state.q.setIdentity(data_.rows(), 2 * modes);
    state.q.applyOnTheLeft(qr_.householderQ());
    state.r = qr_.matrixQR().topRows(2 * modes).triangularView<Eigen::Upper>();
    along_.noalias() = state.q.transpose() * data_;
    state.amplitude = state.r.triangularView<Eigen::Upper>().solve(along_);
    state.residual = data_;
    state.residual.noalias() -= state.q * along_;
    along_.noalias() = state.q.transpose() * state.slope;
    state.slope.noalias() -= state.q * along_;
  }

  template <class Keep>
  NormalEquations sum_over(const Keep& keep) const {
    const auto modes = static_cast<Index>(now_.rates.size());
    NormalEquations out{.matrix = Eigen::MatrixXd::Zero(2 * modes, 2 * modes),
                        .right = Eigen::VectorXd::Zero(2 * modes)};
    const Eigen::MatrixXd gram = now_.slope.transpose() * now_.slope;
    const Eigen::MatrixXd gradient = now_.slope.transpose() * now_.residual;
    for (Index i = 0; i < data_.cols(); ++i) {
      if (!keep(i)) continue;
      Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(2 * modes, 2 * modes);
      for (Index m = 0; m < modes; ++m)
        turn.block<2, 2>(2 * m, 2 * m) = rotation(now_.amplitude(2 * m, i), now_.amplitude(2 * m + 1, i));
      out.matrix += weight_(i) * turn.transpose() * gram * turn;
      out.right += weight_(i) * turn.transpose() * gradient.col(i);
    }
    return out;
  }

  std::vector<std::pair<std::size_t, std::size_t>> windows_;
  const DecaySpectra& spectra_;
  Eigen::MatrixXd data_;
  Eigen::VectorXd inverse_std_;     // [lines], of DecayGroup::line_std
  Eigen::VectorXd level_, weight_;  // [hits × channels]
  State now_, trial_;
  Eigen::MatrixXd columns_, along_;
  Eigen::HouseholderQR<Eigen::MatrixXd> qr_;
  NormalEquations equations_;
};

// DecayGroupFit::misfit. Neighbouring lines' residuals are independent where the model is complete.
double misfit_factor(const Eigen::MatrixXd& residual) {
  const Index lines = residual.rows() / 2;
  double all = 0, neighbours = 0;
  for (Index i = 0; i < residual.cols(); ++i) {
    for (Index half = 0; half < 2; ++half) {
      const auto part = residual.col(i).segment(half * lines, lines);
      all += part.squaredNorm();
      neighbours += part.head(lines - 1).dot(part.tail(lines - 1));
    }
  }
  if (!(all > 0)) return 1;
  // Three standard deviations of the correlation of white residuals.
  const double correlation = neighbours / all;
  const double chance = 3 / std::sqrt(static_cast<double>(2 * lines * residual.cols()));
  return correlation > chance ? std::sqrt((1 + correlation) / std::max(0.05, 1 - correlation)) : 1;
}

}  // namespace

DecayGroupFit fit_decay_group(const DecayGroup& group, const DecaySpectra& spectra, const Eigen::MatrixXcd& data,
                              DecayAccuracy accuracy) {
  DecayProblem problem(group, spectra, data);
  constexpr LevenbergMarquardtOptions kFull{.max_steps = 40, .step_tolerance = 1e-14, .cost_tolerance = 1e-12};
  constexpr LevenbergMarquardtOptions kRough{.max_steps = 12, .step_tolerance = 1e-8, .cost_tolerance = 1e-4};
  const bool rough = accuracy == DecayAccuracy::rough;
  DecayGroupFit out;
  const int rounds = rough ? 1 : 3;  // the weights need the residual, and the fit the weights
  for (int round = 0; round < rounds; ++round) {
    out.noise = problem.set_weights_from_residual();
    const LevenbergMarquardtSummary summary = levenberg_marquardt(problem, rough ? kRough : kFull);
    // The rates also stand still where no trial lowers the cost: no_decrease counts as converged here.
    out.converged = summary.stop != LevenbergMarquardtStop::max_steps;
    if (spectra.channels == 1) break;
  }
  out.noise = problem.set_weights_from_residual();
  const State& state = problem.state();
  const auto modes = static_cast<Index>(state.rates.size());
  out.rates = state.rates;
  out.amplitude.resize(modes, data.cols());
  for (Index m = 0; m < modes; ++m) {
    out.amplitude.row(m).real() = state.amplitude.row(2 * m);
    out.amplitude.row(m).imag() = state.amplitude.row(2 * m + 1);
  }
  out.covariance = core::inverse_gram(problem.normal_equations().matrix);
  const Eigen::MatrixXd inverse_r =
      state.r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(2 * modes, 2 * modes));
  out.inverse_gram = inverse_r * inverse_r.transpose();
  for (std::size_t h = 0; h < spectra.hits; ++h) {
    const NormalEquations alone = problem.of_hit(h);
    out.hit_step.push_back(solve_gram(alone.matrix, alone.right));
    out.hit_information.push_back(alone.matrix);
  }
  out.misfit = misfit_factor(state.residual);
  return out;
}

}  // namespace percuss::identify
