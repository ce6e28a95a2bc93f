#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "core/linear_algebra.hpp"

namespace percuss {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

MatrixXd eigenvectors(const MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric).eigenvectors().rowwise().reverse();
}

VectorXd singular_values(const MatrixXcd& matrix) { return Eigen::JacobiSVD<MatrixXcd>(matrix).singularValues(); }

VectorXcd leading_right_vector(const MatrixXcd& matrix) {
  return Eigen::JacobiSVD<MatrixXcd>(matrix, Eigen::ComputeThinV).matrixV().col(0);
}

}  // namespace percuss
