// The effect of the force channel's noise on a joint fit: a gain error ε(ω) adds ε·H to every FRF of its point.
#include <algorithm>

#include "core/math/tall_products.hpp"
#include "core/parallel/parallel.hpp"
#include "identify/fit/joint_projection.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// ε·H of one FRF for each variable of ε. shapes  response [rows], errors [groups, variables].
MatrixXd times_response(const MatrixXcd& errors, const VectorXd& response) {
  const Index groups = errors.rows();
  const MatrixXd re = errors.real();
  const MatrixXd im = errors.imag();
  const auto h_re = response.head(groups).asDiagonal();
  const auto h_im = response.tail(groups).asDiagonal();
  MatrixXd response_error(2 * groups, errors.cols());
  response_error.topRows(groups) = h_re * re - h_im * im;
  response_error.bottomRows(groups) = h_re * im + h_im * re;
  return response_error;
}

std::vector<std::vector<std::size_t>> by_point(const FrfDataset& set, const JointPart& part) {
  std::vector<std::vector<std::size_t>> points;
  for (std::size_t i = 0; i < part.channels.size(); ++i) {
    const auto point = [&](std::size_t at) { return set.channels[part.channels[at]].point; };
    if (i == 0 || point(i) != point(i - 1)) points.emplace_back();
    points.back().push_back(i);
  }
  return points;
}

}  // namespace

void JointProjection::add_force_noise(const JointState& state, const JointPart& part, ForceErrors of,
                                      MatrixXd& covariance) const {
  const MatrixXd projection = part.inverse * tall_transposed_product(part.columns, part.slopes);
  const MatrixXd synthesised = tall_product(part.columns, part.amplitude);
  const std::vector<std::size_t> lines = groups_.middles();
  const auto points = by_point(set_, part);
  std::vector<MatrixXd> pole_scores(points.size());
  parallel_for_cost(
      points.size(), kFlopsPerProduct * lines.size() * static_cast<std::size_t>(part.slopes.cols()),
      [&](std::size_t p) {
        const MatrixXcd errors = gain_errors(set_, set_.channels[part.channels[points[p].front()]].point, lines, of);
        for (const std::size_t i : points[p]) {
          if (errors.size() == 0) break;
          const auto o = static_cast<Index>(i);
          const MatrixXd response_error = times_response(errors, synthesised.col(o));
          const MatrixXd score = tall_transposed_product(part.slopes, response_error) -
                                 projection.transpose() * tall_transposed_product(part.columns, response_error);
          const MatrixXd contribution =
              residue_matrix(state, part, o).transpose() * score / noise_(static_cast<Index>(part.channels[i]));
          if (pole_scores[p].size() == 0) pole_scores[p] = MatrixXd::Zero(contribution.rows(), contribution.cols());
          pole_scores[p] += contribution;
        }
      });
  for (const MatrixXd& pole_score : pole_scores) {
    if (pole_score.size() > 0) covariance += pole_score * pole_score.transpose();
  }
}

void JointProjection::add_residue_variance(const JointState& state, const JointPart& part, MatrixXd& variance) const {
  const MatrixXd synthesised = tall_product(part.columns, part.amplitude);
  const std::vector<std::size_t> lines = groups_.middles();
  const auto points = by_point(set_, part);
  parallel_for_cost(
      points.size(), kFlopsPerProduct * lines.size() * static_cast<std::size_t>(part.columns.cols()),
      [&](std::size_t p) {
        const MatrixXcd errors = gain_errors(set_, set_.channels[part.channels[points[p].front()]].point, lines);
        for (const std::size_t i : points[p]) {
          if (errors.size() == 0) break;
          const auto o = static_cast<Index>(i);
          const MatrixXd residue_errors =
              part.inverse * tall_transposed_product(part.columns, times_response(errors, synthesised.col(o)));
          for (std::size_t m = 0; m < state.model.poles.size(); ++m) {
            const auto first = static_cast<Index>(part.first[m]);
            const double line = set_.lines.position(state.model.poles[m].freq_Hz);
            const auto above = std::lower_bound(lines.begin(), lines.end(), line,
                                                [](std::size_t a, double b) { return static_cast<double>(a) < b; });
            const Index at = std::min<Index>(above - lines.begin(), errors.rows() - 1);
            const bool real = state.model.real[m] != 0;
            const Complex residue(part.amplitude(first, o), real ? 0 : part.amplitude(first + 1, o));
            const Eigen::RowVectorXcd gain = residue * errors.row(at);
            double sum = (residue_errors.row(first) - gain.real()).squaredNorm();
            if (!real) sum = 0.5 * (sum + (residue_errors.row(first + 1) - gain.imag()).squaredNorm());
            variance(static_cast<Index>(part.channels[i]), static_cast<Index>(m)) = sum;
          }
        }
      });
}

}  // namespace percuss::identify
