#pragma once
#include <Eigen/Core>

namespace percuss::inline core {

/// The roots of w^n + c_1 w^(n−1) + … + c_n by Aberth's simultaneous Newton iteration from `start` (n different
/// values: the roots of a similar polynomial settle in a few steps); where that does not settle, the eigenvalues of the
/// companion matrix. shapes: c, start and result [n]; a result stands where its start stood, unless it is an
/// eigenvalue.
Eigen::VectorXcd polynomial_roots(const Eigen::VectorXcd& c, const Eigen::VectorXcd& start);

/// … as the eigenvalues of the companion matrix, from no start at all, at some thirty times the work.
Eigen::VectorXcd companion_roots(const Eigen::VectorXcd& c);

}  // namespace percuss::inline core
