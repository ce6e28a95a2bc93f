#include "core/math/decompositions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace percuss::decompositions_test {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Complex = std::complex<double>;

// The tolerances in this file are a few roundings.

// [[2, 1], [1, 2]] stretches (1, 1) by 3 and (1, −1) by 1.
TEST(Eigenvectors, AreOrderedByDescendingEigenvalue) {
  const MatrixXd vectors = eigenvectors((MatrixXd(2, 2) << 2, 1, 1, 2).finished());
  EXPECT_NEAR(vectors(0, 0), vectors(1, 0), 1e-15);
  EXPECT_NEAR(vectors(0, 1), -vectors(1, 1), 1e-15);
}

// 5·u·vᴴ + 2·p·qᴴ with orthonormal u ⊥ p, v ⊥ q.
TEST(SingularValues, OfAMatrixMadeFromThem) {
  const double h = std::sqrt(0.5);
  Eigen::VectorXcd u(2), p(2), v(3), q(3);
  u << h, Complex(0, h);
  p << h, Complex(0, -h);
  v << Complex(0, 0.6), 0.8, 0.0;
  q << Complex(0, -0.8), 0.6, 0.0;
  const MatrixXcd matrix = 5.0 * u * v.adjoint() + 2.0 * p * q.adjoint();
  EXPECT_NEAR(singular_values(matrix)(0), 5, 1e-14);
  EXPECT_NEAR(singular_values(matrix)(1), 2, 1e-14);
  EXPECT_NEAR(singular_values(matrix.adjoint())(1), 2, 1e-14);
  EXPECT_EQ(singular_values(matrix).size(), 2);
  EXPECT_NEAR(std::abs(leading_right_vector(matrix).dot(v)), 1, 1e-14);
}

}  // namespace percuss::decompositions_test
