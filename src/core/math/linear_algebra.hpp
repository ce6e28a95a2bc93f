#pragma once
#include <Eigen/Core>
#include <optional>

namespace percuss {
inline namespace core {

/// Inverse of a symmetric (Hermitian) positive definite matrix. It is scaled to ones on the diagonal first, because the
/// diagonal may span many decades. shape [n, n].
Eigen::MatrixXd inverse_gram(const Eigen::MatrixXd& gram);
Eigen::MatrixXcd inverse_gram(const Eigen::MatrixXcd& gram);

/// Solution x of gram·x = right with the diagonal multiplied by 1 + damping (Marquardt), scaled in the same way.
/// shapes: gram [n, n], right and result [n].
/// theory (4.10)
Eigen::VectorXd solve_gram(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, double damping = 0);

/// Orthonormal polynomials of degree 0 … terms − 1 over `points` equidistant points. shape [points, terms].
Eigen::MatrixXd orthonormal_polynomials(Eigen::Index points, Eigen::Index terms);

/// The x that minimises |columns·x − right|, by QR with column pivoting. shapes: columns [n, m], right [n], result [m].
Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right);

/// The pseudo-inverse: its product with `right` is the least-squares solution. Nothing when a pivot is below
/// `min_pivot` of the largest. For small n. shapes: columns [n, m], result [m, n].
std::optional<Eigen::MatrixXd> left_inverse(const Eigen::MatrixXd& columns, double min_pivot);

}  // namespace core
}  // namespace percuss
