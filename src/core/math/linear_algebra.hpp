#pragma once
#include <Eigen/Core>
#include <optional>

namespace percuss::inline core {

/// Inverse of a symmetric (Hermitian) positive matrix whose diagonal may span many decades: scaled to ones on the
/// diagonal first. shape [n, n].
Eigen::MatrixXd inverse_gram(const Eigen::MatrixXd& gram);
Eigen::MatrixXcd inverse_gram(const Eigen::MatrixXcd& gram);

/// Solution x of gram·x = right with the diagonal raised by the factor 1 + damping (Marquardt), scaled likewise.
/// shapes: gram [n, n], right and result [n].
/// theory (4.10)
Eigen::VectorXd solve_gram(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, double damping = 0);

/// Polynomials of degree 0 … terms − 1 over `points` equal steps, orthonormal. shape [points, terms].
Eigen::MatrixXd orthonormal_polynomials(Eigen::Index points, Eigen::Index terms);

/// The x that minimises |columns·x − right|, by QR with column pivoting. shapes: columns [n, m], right [n], result [m].
Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right);

/// The pseudo-inverse, whose product with any `right` is the above; none when a pivot falls below `min_pivot` of the
/// largest. shapes: columns [n, m], result [m, n]: for small n.
std::optional<Eigen::MatrixXd> left_inverse(const Eigen::MatrixXd& columns, double min_pivot);

}  // namespace percuss::inline core
