#include "identify/misfit/residual_correlation.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/tall_products.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr Index kTestedLags = 3;  // smooth misfit correlates over several lines

// Lagged covariance of the part of white noise (of unit variance) that the fit removes. In the residual it has the
// opposite sign.
double removed(const ProjectedPart& part, const Eigen::MatrixXd& polynomial, Index lag) {
  const Index count = polynomial.rows() - lag;
  double sum = polynomial.topRows(count).cwiseProduct(polynomial.bottomRows(count)).sum();
  const MatrixXcd columns = lagged_product(part.columns, part.columns, lag);
  sum += part.inverse_gram.cwiseProduct(columns.transpose()).sum().real();
  return sum;
}

double lines_of(const ProjectedState& state) {
  double lines = 0;
  for (const ProjectedPart& part : state.parts)
    lines += static_cast<double>(part.residual.rows()) * static_cast<double>(part.channels.size());
  return lines;
}

// The residual's lagged covariance, normalised, without the part that white noise shows.
double correlation(const ProjectedState& state, const Eigen::MatrixXd& polynomial, const Eigen::VectorXd& noise,
                   Index lag) {
  double sum = 0;
  for (const ProjectedPart& part : state.parts) {
    const Index count = part.residual.rows() - lag;
    const double expected = -removed(part, polynomial, lag);
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
      const auto residual = part.residual.col(static_cast<Index>(i));
      const double w = noise(static_cast<Index>(part.channels[i]));
      sum += residual.head(count).dot(residual.tail(count)).real() / (w * w) - expected;
    }
  }
  return sum / lines_of(state);
}

}  // namespace

MatrixXcd lagged_product(const MatrixXcd& left, const MatrixXcd& right, Index lag) {
  const Index count = left.rows() - lag;
  return left.topRows(count).adjoint().lazyProduct(right.bottomRows(count));
}

ResidualCorrelation residual_correlation(const ProjectedState& state, const Eigen::MatrixXd& polynomial,
                                         const Eigen::VectorXd& noise) {
  ResidualCorrelation out;
  const Index most = polynomial.rows() / 3;
  double tested = 0;
  for (Index lag = 1; lag <= most; ++lag) {
    const double now = correlation(state, polynomial, noise, lag);
    if (lag <= kTestedLags) tested += now;
    if (lag > kTestedLags && now <= 0) break;
    out.at_lag.push_back(std::max(now, 0.0));
    out.lines += 2 * out.at_lag.back();
  }
  out.deviate = tested * std::sqrt(2 * lines_of(state) / static_cast<double>(kTestedLags));
  return out;
}

}  // namespace percuss::identify
