#include "core/math/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace percuss {
inline namespace core {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::SelfAdjointEigenSolver;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// AᴴA as a real matrix, which has every eigenvalue twice. Complex decompositions take half a minute to compile.
MatrixXd real_gram(const MatrixXcd& a) {
  const MatrixXcd gram = a.adjoint() * a;
  MatrixXd out(2 * gram.rows(), 2 * gram.rows());
  out << gram.real(), -gram.imag(), gram.imag(), gram.real();
  return out;
}

}  // namespace

MatrixXd eigenvectors(const MatrixXd& symmetric) {
  return SelfAdjointEigenSolver<MatrixXd>(symmetric).eigenvectors().rowwise().reverse();
}

VectorXd singular_values(const MatrixXcd& matrix) {
  const bool tall = matrix.rows() >= matrix.cols();
  const MatrixXd gram = real_gram(tall ? matrix : MatrixXcd(matrix.adjoint()));
  const VectorXd squares = SelfAdjointEigenSolver<MatrixXd>(gram, Eigen::EigenvaluesOnly).eigenvalues();
  VectorXd out(gram.rows() / 2);
  for (Index i = 0; i < out.size(); ++i) out(i) = std::sqrt(std::max(0.0, squares(squares.size() - 1 - 2 * i)));
  return out;
}

VectorXcd leading_right_vector(const MatrixXcd& matrix) {
  const VectorXd both = eigenvectors(real_gram(matrix)).col(0);
  VectorXcd out(matrix.cols());
  out.real() = both.head(matrix.cols());
  out.imag() = both.tail(matrix.cols());
  return out;
}

}  // namespace core
}  // namespace percuss
