// The residual of a joint fit, and the weights that follow from it.
#include <algorithm>
#include <cmath>

#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/fit/joint_projection.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// On either side of a line. The error of a noise power from 200 lines adds under 1 % to the errors of the fit.
constexpr Index kSmoothLines = 100;
constexpr double kMinNoise = 1e-3;  // of the mean noise power: lines without residual keep a finite weight

}  // namespace

std::vector<VectorXcd> JointProjection::unweighted_residual(const JointState& state) const {
  std::vector<VectorXcd> residual(set_.channels.size());
  const auto lines = static_cast<Index>(set_.lines.count);
  const std::vector<ModeColumn> whole = untruncated_columns(state.model, ColumnContent::value);
  const std::size_t each = kFlopsPerColumnLine * set_.lines.count * state.model.poles.size();
  parallel_for_cost(state.parts.size(), each, [&](std::size_t p) {
    const JointPart& part = state.parts[p];
    const PointForce& force = set_.points[set_.channels[part.channels.front()].point];
    MatrixXcd columns(lines, part.columns.cols());
    parallel_for_cost(state.model.poles.size(), kFlopsPerColumnLine * set_.lines.count, [&](std::size_t m) {
      const auto first = static_cast<Index>(part.first[m]);
      columns.col(first) = subtract_truncation(whole[m], state.model.poles[m], force, set_.lines, 0).value;
      if (!state.model.real[m]) columns.col(first + 1) = Complex(0, 1) * columns.col(first);
    });
    const Index columns_per_term = state.model.all_real() ? 1 : 2;
    for (Index term = 0; term < background_.cols(); ++term) {
      const Index at = columns.cols() - columns_per_term * (background_.cols() - term);
      columns.col(at) = background_.col(term).cast<Complex>();
      if (columns_per_term == 2) columns.col(at + 1) = Complex(0, 1) * columns.col(at);
    }
    subtract_model(columns, part, residual);
  });
  return residual;
}

// The residual of each FRF of the part.
void JointProjection::subtract_model(const MatrixXcd& columns, const JointPart& part,
                                     std::vector<VectorXcd>& residual) const {
  for (const std::size_t o : part.channels) residual[o].resize(columns.rows());
  const auto operations = kFlopsPerProduct * static_cast<std::size_t>(columns.cols()) * part.channels.size();
  parallel_for_chunks(set_.lines.count, operations, [&](std::size_t from, std::size_t lines) {
    const auto first = static_cast<Index>(from), count = static_cast<Index>(lines);
    // The amplitudes are real, so that one product serves real and imaginary parts.
    const MatrixXcd strip = columns.middleRows(first, count);
    const MatrixXd share =
        tall_product(Eigen::Map<const MatrixXd>(reinterpret_cast<const double*>(strip.data()), 2 * count, strip.cols()),
                     part.amplitude);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const Eigen::Map<const VectorXcd> frf(set_.channels[part.channels[i]].frf.data() + from, count);
      const auto* made = reinterpret_cast<const Complex*>(share.col(static_cast<Index>(i)).data());
      residual[part.channels[i]].segment(first, count) = frf - Eigen::Map<const VectorXcd>(made, count);
    }
  });
}

void JointProjection::weight_by_residual(const JointState& state, const std::vector<VectorXcd>& residual) {
  const auto lines = static_cast<Index>(set_.lines.count);
  for (std::size_t p = 0; p < plans_.size(); ++p) {
    const JointPart& part = state.parts[p];
    const double freedom = std::max(
        1.0, static_cast<double>(2 * lines - part.columns.cols()) -
                 2 * static_cast<double>(state.model.poles.size()) / static_cast<double>(set_.channels.size()));
    std::vector<VectorXd> weighted(part.channels.size());
    parallel_for_cost(weighted.size(), kFlopsPerProduct * set_.lines.count, [&](std::size_t i) {
      weighted[i] = residual[part.channels[i]].cwiseAbs2().cwiseProduct(plans_[p].weight.cwiseAbs2());
      const double variance = std::max(weighted[i].sum() / freedom, 1e-300);
      noise_(static_cast<Index>(part.channels[i])) = std::sqrt(variance);
      weighted[i] /= variance;
    });
    VectorXd power = VectorXd::Zero(lines);
    for (const VectorXd& one : weighted) power += one;
    power /= 2 * static_cast<double>(part.channels.size());  // about 1 everywhere for white noise
    VectorXd sum(lines + 1);
    sum(0) = 0;
    for (Index k = 0; k < lines; ++k) sum(k + 1) = sum(k) + power(k);
    for (Index k = 0; k < lines; ++k) {
      const Index from = std::max<Index>(0, std::min(k - kSmoothLines, lines - 1 - 2 * kSmoothLines));
      const Index to = std::min(lines, from + 2 * kSmoothLines + 1);
      const double local = (sum(to) - sum(from)) / static_cast<double>(to - from);
      plans_[p].weight(k) /= std::sqrt(std::max(local, kMinNoise));
    }
    fill(plans_[p]);
  }
}

}  // namespace percuss::identify
