#include "identify/joint_projection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "identify/force_noise.hpp"

namespace percuss {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// What lies beyond the lines, as accelerance of undamped guard modes at fixed places: the highest line over the mode's
// frequency, squared. 0 is the mass line.
constexpr std::array<double, 5> kGuards{0, 0.87, 0.6, 0.3, 0.1};
constexpr Index kBackground = static_cast<Index>(kGuards.size()) + 1;  // … and one below the lines
constexpr Index kSmoothLines = 100;   // on either side: a variance from 200 lines costs under 1 % of the bound
constexpr double kLeastNoise = 1e-3;  // of the noise elsewhere: where a fit leaves nothing, its weight stays finite

// Real over imaginary parts of w·z, and of j·w·z.
void stack(const VectorXcd& z, const VectorXd& w, Eigen::Ref<VectorXd> column) {
  column.head(z.size()) = z.real().cwiseProduct(w);
  column.tail(z.size()) = z.imag().cwiseProduct(w);
}
void stack_turned(const VectorXcd& z, const VectorXd& w, Eigen::Ref<VectorXd> column) {
  column.head(z.size()) = -z.imag().cwiseProduct(w);
  column.tail(z.size()) = z.real().cwiseProduct(w);
}

// Inverse of a Gram matrix whose columns may differ by many decades.
MatrixXd inverse_gram(const MatrixXd& columns) {
  const MatrixXd gram = columns.transpose() * columns;
  const VectorXd scale = gram.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const MatrixXd even = scale.asDiagonal() * gram * scale.asDiagonal();
  const MatrixXd solved = even.ldlt().solve(MatrixXd::Identity(gram.rows(), gram.cols()));
  return scale.asDiagonal() * solved * scale.asDiagonal();
}

}  // namespace

bool JointModel::all_real() const {
  return std::all_of(real.begin(), real.end(), [](char r) { return r != 0; });
}

JointProjection::JointProjection(const FrfSet& set, const std::vector<Pole>& poles)
    : set_(set), noise_(VectorXd::Ones(static_cast<Index>(set.outputs.size()))) {
  const bool together = std::all_of(set.points.begin(), set.points.end(), [&](const PointForce& force) {
    return std::all_of(poles.begin(), poles.end(), [&](const Pole& p) { return decays_within(p, force, set.lines); });
  });
  parts_.resize(together ? 1 : set.points.size());
  for (std::size_t o = 0; o < set.outputs.size(); ++o) parts_[together ? 0 : set.outputs[o].point].outputs.push_back(o);
  std::erase_if(parts_, [](const Plan& plan) { return plan.outputs.empty(); });
  for (Plan& plan : parts_) {
    // An H1 line's noise goes down as the force's energy goes up.
    plan.weight = VectorXd::Zero(static_cast<Index>(set.lines.count));
    for (const std::size_t o : plan.outputs) {
      const auto& ff = set.points[set.outputs[o].point].ff;
      plan.weight += ff.empty() ? VectorXd::Ones(plan.weight.size())
                                : VectorXd(Eigen::Map<const VectorXd>(ff.data(), plan.weight.size()));
    }
    plan.weight = (plan.weight / static_cast<double>(plan.outputs.size())).cwiseSqrt();
    fill(plan);
  }
}

void JointProjection::fill(Plan& plan) const {
  const auto lines = static_cast<Index>(set_.lines.count);
  plan.data.resize(2 * lines, static_cast<Index>(plan.outputs.size()));
  for (std::size_t i = 0; i < plan.outputs.size(); ++i) {
    const Eigen::Map<const VectorXcd> frf(set_.outputs[plan.outputs[i]].frf.data(), lines);
    stack(frf, plan.weight, plan.data.col(static_cast<Index>(i)));
  }
}

JointState JointProjection::evaluate(JointModel model) const {
  JointState state{.model = std::move(model), .parts = {}};
  for (const Plan& plan : parts_) {
    state.parts.push_back(solve(plan, state.model));
    const JointPart& part = state.parts.back();
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      const double noise = noise_(static_cast<Index>(part.outputs[i]));
      state.cost += part.residual.col(static_cast<Index>(i)).squaredNorm() / (noise * noise);
    }
  }
  return state;
}

// Real coefficients, or real and imaginary ones in turn.
void JointProjection::add_background(const Plan& plan, Eigen::Ref<MatrixXd> columns) const {
  const auto lines = static_cast<Index>(set_.lines.count);
  const Index turns = columns.cols() / kBackground;
  const VectorXd freq = VectorXd::LinSpaced(lines, set_.lines.freq_Hz(0), set_.lines.freq_Hz(set_.lines.count - 1));
  const Eigen::ArrayXd x = (freq / freq(lines - 1)).array().square();
  const double lowest = std::max(x(0), x(1) * 0.25);  // a band may begin at 0 Hz
  for (Index term = 0; term < kBackground; ++term) {
    const bool below = term + 1 == kBackground;
    const Eigen::ArrayXd shape =
        below ? (lowest / x.max(lowest)).eval() : (1 / (1 - kGuards[static_cast<std::size_t>(term)] * x)).eval();
    const VectorXd weighted = plan.weight.array() * shape;
    columns.col(turns * term).head(lines) = weighted;
    if (turns == 2) columns.col(turns * term + 1).tail(lines) = weighted;
  }
}

JointPart JointProjection::solve(const Plan& plan, const JointModel& model) const {
  const auto lines = static_cast<Index>(set_.lines.count);
  const auto modes = static_cast<Index>(model.poles.size());
  JointPart part;
  part.outputs = plan.outputs;
  Index unknowns = 0;
  for (const char real : model.real) {
    part.first.push_back(static_cast<std::size_t>(unknowns));
    unknowns += real ? 1 : 2;
  }
  const PointForce& force = set_.points[set_.outputs[plan.outputs.front()].point];
  const Index turns = model.all_real() ? 1 : 2;  // real coefficients of the background, or complex ones
  part.columns = MatrixXd::Zero(2 * lines, unknowns + turns * kBackground);
  part.slopes.resize(2 * lines, 2 * unknowns);
  part.quadrature.resize(2 * lines, modes);
  for (Index m = 0; m < modes; ++m) {
    const auto at = static_cast<std::size_t>(m);
    const ModeColumn mode = mode_column(model.poles[at], force, set_.lines, 0, set_.lines.count);
    const auto first = static_cast<Index>(part.first[at]);
    stack(mode.value, plan.weight, part.columns.col(first));
    stack(mode.by_freq, plan.weight, part.slopes.col(2 * first));
    stack(mode.by_damping, plan.weight, part.slopes.col(2 * first + 1));
    stack_turned(mode.value, plan.weight, part.quadrature.col(m));
    if (model.real[at]) continue;
    part.columns.col(first + 1) = part.quadrature.col(m);
    stack_turned(mode.by_freq, plan.weight, part.slopes.col(2 * first + 2));
    stack_turned(mode.by_damping, plan.weight, part.slopes.col(2 * first + 3));
  }
  add_background(plan, part.columns.rightCols(part.columns.cols() - unknowns));
  part.inverse = inverse_gram(part.columns);
  part.amplitude = part.inverse * (part.columns.transpose() * plan.data);
  part.residual = plan.data - part.columns * part.amplitude;
  // Once more with what is left: the normal equations alone lose half of the digits.
  const MatrixXd correction = part.inverse * (part.columns.transpose() * part.residual);
  part.amplitude += correction;
  part.residual -= part.columns * correction;
  return part;
}

JointNormal JointProjection::normal_equations(const JointState& state) const {
  const auto modes = static_cast<Index>(state.model.poles.size());
  JointNormal out{.matrix = MatrixXd::Zero(2 * modes, 2 * modes), .right = VectorXd::Zero(2 * modes), .force = {}};
  for (const JointPart& part : state.parts) {
    // What the linear part cannot follow of the slopes (Kaufman's Jacobian).
    const MatrixXd cross = part.columns.transpose() * part.slopes;
    const MatrixXd gram = part.slopes.transpose() * part.slopes - cross.transpose() * part.inverse * cross;
    const MatrixXd push = part.slopes.transpose() * part.residual;
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      const auto o = static_cast<Index>(i);
      const MatrixXd spread = spread_of(state, part, o);
      out.matrix += spread.transpose() * gram * spread;
      out.right += spread.transpose() * push.col(o) / noise_(static_cast<Index>(part.outputs[i]));
    }
  }
  return out;
}

// From slope columns to the unknowns of the poles, with an output's residues, in units of its noise.
MatrixXd JointProjection::spread_of(const JointState& state, const JointPart& part, Index output) const {
  const double noise = noise_(static_cast<Index>(part.outputs[static_cast<std::size_t>(output)]));
  const auto modes = static_cast<Index>(state.model.poles.size());
  MatrixXd spread = MatrixXd::Zero(part.slopes.cols(), 2 * modes);
  for (Index m = 0; m < modes; ++m) {
    const auto first = static_cast<Index>(part.first[static_cast<std::size_t>(m)]);
    for (Index k = 0; k < (state.model.real[static_cast<std::size_t>(m)] ? 1 : 2); ++k) {
      spread(2 * (first + k), 2 * m) = part.amplitude(first + k, output) / noise;
      spread(2 * (first + k) + 1, 2 * m + 1) = part.amplitude(first + k, output) / noise;
    }
  }
  return spread;
}

JointNormal JointProjection::with_force_noise(const JointState& state) const {
  JointNormal out = normal_equations(state);
  out.force = MatrixXd::Zero(out.matrix.rows(), out.matrix.cols());
  for (const JointPart& part : state.parts) add_force_noise(state, part, out);
  return out;
}

// A gain error ε(ω) adds ε·H to every response of its point: what that does to the right-hand side.
void JointProjection::add_force_noise(const JointState& state, const JointPart& part, JointNormal& normal) const {
  const auto lines = static_cast<Index>(set_.lines.count);
  const MatrixXd follow = part.inverse * (part.columns.transpose() * part.slopes);
  const MatrixXd synthesised = part.columns * part.amplitude;
  for (std::size_t p = 0; p < set_.points.size(); ++p) {
    MatrixXd push;
    Eigen::MatrixXcd errors;
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      if (set_.outputs[part.outputs[i]].point != p) continue;
      if (errors.size() == 0) errors = gain_errors(set_, p, 0, set_.lines.count);
      if (errors.size() == 0) break;
      const auto o = static_cast<Index>(i);
      const MatrixXd re = errors.real();
      const MatrixXd im = errors.imag();
      MatrixXd moved(2 * lines, errors.cols());
      const auto h_re = synthesised.col(o).head(lines).asDiagonal();
      const auto h_im = synthesised.col(o).tail(lines).asDiagonal();
      moved.topRows(lines) = h_re * re - h_im * im;
      moved.bottomRows(lines) = h_re * im + h_im * re;
      const MatrixXd score = part.slopes.transpose() * moved - follow.transpose() * (part.columns.transpose() * moved);
      const MatrixXd spread = spread_of(state, part, o);
      const MatrixXd mine = spread.transpose() * score / noise_(static_cast<Index>(part.outputs[i]));
      if (push.size() == 0) push = MatrixXd::Zero(mine.rows(), mine.cols());
      push += mine;
    }
    if (push.size() > 0) normal.force += push * push.transpose();
  }
}

void JointProjection::weigh_by(const JointState& state) {
  const auto lines = static_cast<Index>(set_.lines.count);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const JointPart& part = state.parts[p];
    const double freedom =
        std::max(1.0, static_cast<double>(2 * lines - part.columns.cols()) -
                          2 * static_cast<double>(state.model.poles.size()) / static_cast<double>(set_.outputs.size()));
    VectorXd power = VectorXd::Zero(lines);
    for (std::size_t i = 0; i < part.outputs.size(); ++i) {
      const auto residual = part.residual.col(static_cast<Index>(i));
      const double variance = std::max(residual.squaredNorm() / freedom, 1e-300);
      noise_(static_cast<Index>(part.outputs[i])) = std::sqrt(variance);
      power += (residual.head(lines).cwiseAbs2() + residual.tail(lines).cwiseAbs2()) / variance;
    }
    power /= 2 * static_cast<double>(part.outputs.size());  // about 1 everywhere when the noise is even
    VectorXd sum(lines + 1);
    sum(0) = 0;
    for (Index k = 0; k < lines; ++k) sum(k + 1) = sum(k) + power(k);
    for (Index k = 0; k < lines; ++k) {
      const Index from = std::max<Index>(0, std::min(k - kSmoothLines, lines - 1 - 2 * kSmoothLines));
      const Index to = std::min(lines, from + 2 * kSmoothLines + 1);
      const double local = (sum(to) - sum(from)) / static_cast<double>(to - from);
      parts_[p].weight(k) /= std::sqrt(std::max(local, kLeastNoise));
    }
    fill(parts_[p]);
  }
}

}  // namespace percuss
