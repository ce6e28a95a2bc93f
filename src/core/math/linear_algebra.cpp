#include "core/math/linear_algebra.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>

namespace percuss {
inline namespace core {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The factors that scale the diagonal to ones; 1 for an unknown without influence.
template <class Matrix>
VectorXd unit_diagonal_scaling(const Matrix& gram) {
  return gram.diagonal().real().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1; });
}

template <class Matrix>
Matrix inverse_of(const Matrix& gram) {
  if (gram.size() == 1) return gram.cwiseInverse();  // the most frequent size: each step of a fit of one mode
  const VectorXd scale = unit_diagonal_scaling(gram);
  const Matrix even = scale.asDiagonal() * gram * scale.asDiagonal();
  const Matrix solved = even.ldlt().solve(Matrix::Identity(gram.rows(), gram.cols()));
  return scale.asDiagonal() * solved * scale.asDiagonal();
}

}  // namespace

MatrixXd inverse_gram(const MatrixXd& gram) { return inverse_of(gram); }
MatrixXcd inverse_gram(const MatrixXcd& gram) { return inverse_of(gram); }

VectorXd solve_gram(const MatrixXd& gram, const VectorXd& right, double damping) {
  const VectorXd scale = unit_diagonal_scaling(gram);
  MatrixXd even = scale.asDiagonal() * gram * scale.asDiagonal();
  even.diagonal() *= 1 + damping;
  return scale.cwiseProduct(even.ldlt().solve(scale.cwiseProduct(right)));
}

MatrixXd orthonormal_polynomials(Index points, Index terms) {
  const VectorXd x = VectorXd::LinSpaced(points, -1, 1);
  MatrixXd q(points, terms);
  for (Index term = 0; term < terms; ++term) {
    // x·q_(k−1) = b_k q_k + b_(k−1) q_(k−2). Both factors are near ½ for terms ≪ points, so little cancels.
    const VectorXd next = term == 0 ? VectorXd::Ones(points) : VectorXd(x.cwiseProduct(q.col(term - 1)));
    const auto before = q.leftCols(term);
    q.col(term) = (next - before * (before.transpose() * next)).normalized();
  }
  return q;
}

VectorXd least_squares(const MatrixXd& columns, const VectorXd& right) {
  return Eigen::ColPivHouseholderQR<MatrixXd>(columns).solve(right);
}
std::optional<MatrixXd> left_inverse(const MatrixXd& columns, double min_pivot) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(min_pivot);
  qr.compute(columns);
  if (qr.rank() < columns.cols()) return std::nullopt;
  return qr.solve(MatrixXd::Identity(columns.rows(), columns.rows()));
}

}  // namespace core
}  // namespace percuss
