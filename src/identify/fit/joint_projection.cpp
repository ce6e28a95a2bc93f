#include "identify/fit/joint_projection.hpp"

#include <algorithm>
#include <cmath>

#include "core/budget.hpp"
#include "core/math/linear_algebra.hpp"
#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/model/residual_terms.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr Index kStrip = 16;  // FRFs per block of matrix products

// Multiplies a column (real parts above imaginary parts) by j.
void turn(const Eigen::Ref<const VectorXd>& column, Eigen::Ref<VectorXd> turned) {
  const Index half = column.size() / 2;
  turned.head(half) = -column.tail(half);
  turned.tail(half) = column.head(half);
}

}  // namespace

bool JointModel::all_real() const {
  return std::all_of(real.begin(), real.end(), [](char r) { return r != 0; });
}

JointProjection::JointProjection(const FrfDataset& set, const std::vector<Pole>& poles, double core_share)
    : set_(set),
      groups_(set.lines, poles, core_share),
      background_(out_of_band_terms(set.lines)),
      noise_(VectorXd::Ones(static_cast<Index>(set.channels.size()))) {
  const bool together = std::all_of(set.points.begin(), set.points.end(), [&](const PointForce& force) {
    return std::all_of(poles.begin(), poles.end(),
                       [&](const Pole& p) { return decays_within_record(p, force, set.lines); });
  });
  plans_.resize(together ? 1 : set.points.size());
  for (std::size_t o = 0; o < set.channels.size(); ++o)
    plans_[together ? 0 : set.channels[o].point].channels.push_back(o);
  std::erase_if(plans_, [](const Plan& plan) { return plan.channels.empty(); });
  for (Plan& plan : plans_) {
    // The noise of an H1 estimate falls as the force's energy rises.
    plan.weight = VectorXd::Zero(static_cast<Index>(set.lines.count));
    for (const std::size_t o : plan.channels) {
      const auto& ff = set.points[set.channels[o].point].ff;
      plan.weight += ff.empty() ? VectorXd::Ones(plan.weight.size())
                                : VectorXd(Eigen::Map<const VectorXd>(ff.data(), plan.weight.size()));
    }
    plan.weight = (plan.weight / static_cast<double>(plan.channels.size())).cwiseSqrt();
    fill(plan);
  }
}

void JointProjection::fill(Plan& plan) const {
  const auto lines = static_cast<Index>(set_.lines.count);
  plan.data.resize(2 * groups_.count(), static_cast<Index>(plan.channels.size()));
  parallel_for_cost(plan.channels.size(), kFlopsPerProduct * set_.lines.count, [&](std::size_t i) {
    const Eigen::Map<const VectorXcd> frf(set_.channels[plan.channels[i]].frf.data(), lines);
    groups_.sum(frf, plan.weight, plan.data.col(static_cast<Index>(i)));
  });
  plan.background.resize(2 * groups_.count(), background_.cols());
  for (Index term = 0; term < background_.cols(); ++term)
    groups_.sum(background_.col(term).cast<Complex>(), plan.weight, plan.background.col(term));
}

JointState JointProjection::evaluate(JointModel model, ColumnContent need) const {
  JointState state{.model = std::move(model), .parts = {}};
  const std::vector<ModeColumn> whole = untruncated_columns(state.model, need);
  for (const Plan& plan : plans_) {
    state.parts.push_back(solve(plan, state.model, whole));
    const JointPart& part = state.parts.back();
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const double noise = noise_(static_cast<Index>(part.channels[i]));
      state.cost += part.residual.col(static_cast<Index>(i)).squaredNorm() / (noise * noise);
    }
  }
  return state;
}

std::vector<ModeColumn> JointProjection::untruncated_columns(const JointModel& model, ColumnContent need) const {
  std::vector<ModeColumn> columns(model.poles.size());
  parallel_for_cost(columns.size(), kFlopsPerColumnLine * set_.lines.count, [&](std::size_t m) {
    columns[m] = untruncated_column(model.poles[m], set_.window_decay_per_s(), set_.lines, 0, set_.lines.count, need);
  });
  return columns;
}

JointPart JointProjection::solve(const Plan& plan, const JointModel& model,
                                 const std::vector<ModeColumn>& whole) const {
  const Index rows = 2 * groups_.count();
  const auto modes = static_cast<Index>(model.poles.size());
  JointPart part;
  part.channels = plan.channels;
  Index unknowns = 0;
  for (const char real : model.real) {
    part.first.push_back(static_cast<std::size_t>(unknowns));
    unknowns += real ? 1 : 2;
  }
  const PointForce& force = set_.points[set_.channels[plan.channels.front()].point];
  const Index columns_per_term = model.all_real() ? 1 : 2;  // real or complex coefficients of the background
  part.columns.resize(rows, unknowns + columns_per_term * background_.cols());
  const bool slopes = !whole.empty() && whole.front().by_freq.size() > 0;
  part.slopes.resize(rows, slopes ? 2 * unknowns : 0);
  part.quadrature.resize(rows, slopes ? modes : 0);
  parallel_for_cost(model.poles.size(), kFlopsPerColumnLine * set_.lines.count, [&](std::size_t at) {
    const auto m = static_cast<Index>(at);
    const ModeColumn mode = subtract_truncation(whole[at], model.poles[at], force, set_.lines, 0);
    const auto first = static_cast<Index>(part.first[at]);
    groups_.sum(mode.value, plan.weight, part.columns.col(first));
    if (!slopes) {
      if (!model.real[at]) turn(part.columns.col(first), part.columns.col(first + 1));
      return;
    }
    groups_.sum(mode.by_freq, plan.weight, part.slopes.col(2 * first));
    groups_.sum(mode.by_damping, plan.weight, part.slopes.col(2 * first + 1));
    turn(part.columns.col(first), part.quadrature.col(m));
    if (model.real[at]) return;
    part.columns.col(first + 1) = part.quadrature.col(m);
    turn(part.slopes.col(2 * first), part.slopes.col(2 * first + 2));
    turn(part.slopes.col(2 * first + 1), part.slopes.col(2 * first + 3));
  });
  for (Index term = 0; term < background_.cols(); ++term) {
    const Index at = unknowns + columns_per_term * term;
    part.columns.col(at) = plan.background.col(term);
    if (columns_per_term == 2) turn(part.columns.col(at), part.columns.col(at + 1));
  }
  check_budget();
  part.inverse = inverse_gram(tall_transposed_product(part.columns, part.columns));
  part.amplitude.resize(part.columns.cols(), plan.data.cols());
  part.residual.resize(rows, plan.data.cols());
  const Index strips = (plan.data.cols() + kStrip - 1) / kStrip;
  parallel_for_cost(static_cast<std::size_t>(strips), static_cast<std::size_t>(8 * part.columns.size() * kStrip),
                    [&](std::size_t strip) {
                      const Index first = static_cast<Index>(strip) * kStrip;
                      solve_channels(plan, first, std::min(kStrip, plan.data.cols() - first), part);
                    });
  return part;
}

void JointProjection::solve_channels(const Plan& plan, Index first, Index count, JointPart& part) {
  auto amplitude = part.amplitude.middleCols(first, count);
  auto residual = part.residual.middleCols(first, count);
  amplitude = part.inverse * tall_transposed_product(part.columns, plan.data.middleCols(first, count));
  residual = plan.data.middleCols(first, count) - tall_product(part.columns, amplitude);
  // Iterative refinement: the normal equations alone lose half of the digits.
  const MatrixXd correction = part.inverse * tall_transposed_product(part.columns, residual);
  amplitude += correction;
  residual -= tall_product(part.columns, correction);
}

NormalEquations JointProjection::normal_equations(const JointState& state) const {
  const auto modes = static_cast<Index>(state.model.poles.size());
  NormalEquations out{.matrix = MatrixXd::Zero(2 * modes, 2 * modes), .right = VectorXd::Zero(2 * modes)};
  for (const JointPart& part : state.parts) {
    check_budget();  // with hundreds of modes, each of these products takes up to a second
    // The slopes with their projection on the columns removed (Kaufman's Jacobian).
    const MatrixXd cross = tall_transposed_product(part.columns, part.slopes);
    check_budget();
    const MatrixXd gram = tall_transposed_product(part.slopes, part.slopes) - cross.transpose() * part.inverse * cross;
    const MatrixXd score = tall_transposed_product(part.slopes, part.residual);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto o = static_cast<Index>(i);
      check_budget();
      const MatrixXd residues = residue_matrix(state, part, o);
      out.matrix += residues.transpose() * gram * residues;
      out.right += residues.transpose() * score.col(o) / noise_(static_cast<Index>(part.channels[i]));
    }
  }
  return out;
}

MatrixXd JointProjection::residue_matrix(const JointState& state, const JointPart& part, Index channel) const {
  const double noise = noise_(static_cast<Index>(part.channels[static_cast<std::size_t>(channel)]));
  const auto modes = static_cast<Index>(state.model.poles.size());
  MatrixXd residues = MatrixXd::Zero(part.slopes.cols(), 2 * modes);
  for (Index m = 0; m < modes; ++m) {
    const auto first = static_cast<Index>(part.first[static_cast<std::size_t>(m)]);
    for (Index k = 0; k < (state.model.real[static_cast<std::size_t>(m)] ? 1 : 2); ++k) {
      residues(2 * (first + k), 2 * m) = part.amplitude(first + k, channel) / noise;
      residues(2 * (first + k) + 1, 2 * m + 1) = part.amplitude(first + k, channel) / noise;
    }
  }
  return residues;
}

MatrixXd JointProjection::force_covariance(const JointState& state, ForceErrors of) const {
  const auto unknowns = static_cast<Index>(2 * state.model.poles.size());
  MatrixXd covariance = MatrixXd::Zero(unknowns, unknowns);
  for (const JointPart& part : state.parts) add_force_noise(state, part, of, covariance);
  return covariance;
}

MatrixXd JointProjection::residue_force_variance(const JointState& state) const {
  MatrixXd variance =
      MatrixXd::Zero(static_cast<Index>(set_.channels.size()), static_cast<Index>(state.model.poles.size()));
  for (const JointPart& part : state.parts) add_residue_variance(state, part, variance);
  return variance;
}

}  // namespace percuss::identify
