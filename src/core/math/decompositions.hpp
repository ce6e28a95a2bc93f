#pragma once
#include <Eigen/Core>

namespace percuss::inline core {

/// Eigenvectors of a real symmetric matrix, that of the largest eigenvalue first. shape [n, n], in columns.
Eigen::MatrixXd eigenvectors(const Eigen::MatrixXd& symmetric);

/// Singular values, largest first: square roots of eigenvalues, so that nothing below 1e-8 of the largest is told from
/// rounding. shape [min(rows, columns)].
Eigen::VectorXd singular_values(const Eigen::MatrixXcd& matrix);

/// Right singular vector of the largest singular value, its phase any. shape [columns], norm 1.
Eigen::VectorXcd leading_right_vector(const Eigen::MatrixXcd& matrix);

}  // namespace percuss::inline core
