#include "core/math/linear_algebra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace percuss::linear_algebra_test {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Complex = std::complex<double>;

// The tolerances in this file are a few roundings, of up to 17 terms.

// [[2, 1], [1, 2]] has the inverse [[2, −1], [−1, 2]]/3; scaled by D = diag(1e-9, 1e9) on both sides, its inverse is
// scaled by D⁻¹.
TEST(InverseGram, HoldsOverManyDecades) {
  const VectorXd scale = (VectorXd(2) << 1e-9, 1e9).finished();
  const MatrixXd gram = scale.asDiagonal() * (MatrixXd(2, 2) << 2, 1, 1, 2).finished() * scale.asDiagonal();
  const MatrixXd inverse = inverse_gram(gram);
  EXPECT_NEAR(inverse(0, 0) * 1e-18, 2.0 / 3, 1e-14);
  EXPECT_NEAR(inverse(1, 1) * 1e18, 2.0 / 3, 1e-14);
  EXPECT_NEAR(inverse(0, 1), -1.0 / 3, 1e-14);
}

// [[2, j], [−j, 2]]⁻¹ = [[2, −j], [j, 2]]/3.
TEST(InverseGram, OfAHermitianMatrix) {
  MatrixXcd gram(2, 2);
  gram << 2.0, Complex(0, 1), Complex(0, -1), 2.0;
  const MatrixXcd inverse = inverse_gram(gram);
  EXPECT_NEAR(std::abs(inverse(0, 1) - Complex(0, -1.0 / 3)), 0, 1e-15);
  EXPECT_NEAR(std::abs(inverse(0, 0) - 2.0 / 3), 0, 1e-15);
}

TEST(SolveGram, RaisesTheDiagonalByTheDamping) {
  const MatrixXd gram = (MatrixXd(2, 2) << 2, 1, 1, 2).finished();
  const VectorXd right = (VectorXd(2) << 3, 3).finished();
  EXPECT_NEAR(solve_gram(gram, right)(0), 1, 1e-15);       // 3/(2 + 1)
  EXPECT_NEAR(solve_gram(gram, right, 1)(1), 0.6, 1e-15);  // 3/(4 + 1)
}

TEST(OrthonormalPolynomials, AreOrthonormalAndSpanALine) {
  const MatrixXd q = orthonormal_polynomials(17, 3);
  EXPECT_NEAR((q.transpose() * q - MatrixXd::Identity(3, 3)).norm(), 0, 1e-14);
  const VectorXd line = VectorXd::LinSpaced(17, 2, 5);
  EXPECT_NEAR((line - q.leftCols(2) * (q.leftCols(2).transpose() * line)).norm(), 0, 1e-13);
}

TEST(LeastSquares, OfALineThroughFourPoints) {
  const MatrixXd columns = (MatrixXd(4, 2) << 1, 0, 1, 1, 1, 2, 1, 3).finished();
  const VectorXd right = (VectorXd(4) << 1, 3, 2, 4).finished();  // by hand: intercept 1.3, slope 0.8
  EXPECT_NEAR(least_squares(columns, right)(0), 1.3, 1e-14);
  EXPECT_NEAR(least_squares(columns, right)(1), 0.8, 1e-14);
  const auto inverse = left_inverse(columns, 1e-6);
  ASSERT_TRUE(inverse);
  EXPECT_NEAR((*inverse * right)(1), 0.8, 1e-14);
}

TEST(LeftInverse, IsNothingForNearlyEqualColumns) {
  const MatrixXd columns = (MatrixXd(3, 2) << 1, 1, 1, 1, 1, 1.001).finished();
  EXPECT_TRUE(left_inverse(columns, 1e-6));
  EXPECT_FALSE(left_inverse(columns, 1e-2));
}

}  // namespace percuss::linear_algebra_test
