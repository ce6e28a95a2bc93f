#pragma once
#include <Eigen/Core>

namespace percuss {
inline namespace core {

/// Eigenvectors of a real symmetric matrix by descending eigenvalue. shape [n, n], in columns.
Eigen::MatrixXd eigenvectors(const Eigen::MatrixXd& symmetric);

/// Singular values, largest first. They are square roots of eigenvalues: values below 1e-8 of the largest are rounding
/// errors. shape [min(rows, columns)].
Eigen::VectorXd singular_values(const Eigen::MatrixXcd& matrix);

/// Right singular vector of the largest singular value, with arbitrary phase. shape [columns], norm 1.
Eigen::VectorXcd leading_right_vector(const Eigen::MatrixXcd& matrix);

}  // namespace core
}  // namespace percuss
