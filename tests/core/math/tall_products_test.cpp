#include "core/math/tall_products.hpp"

#include <gtest/gtest.h>

namespace percuss::tall_products_test {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double kRounding = 1e-13;  // of sums of a hundred products of order one

TEST(TallProducts, AgreeWithEigen) {
  for (const Eigen::Index n : {1, 2, 7, 100}) {
    const MatrixXcd a = MatrixXcd::Random(n, 3), b = MatrixXcd::Random(n, 2);
    const MatrixXd r = MatrixXd::Random(n, 2);
    EXPECT_LE((adjoint_product(a, b) - a.adjoint() * b).norm(), kRounding);
    EXPECT_LE((adjoint_gram(a) - a.adjoint() * a).norm(), kRounding);
    EXPECT_LE((transposed_product(r, a) - r.transpose() * a).norm(), kRounding);
    const Eigen::VectorXcd part = a.col(1).tail(n - n / 2);
    EXPECT_LE(std::abs(adjoint_dot(part, a.col(0), n / 2) - part.dot(a.col(0).tail(n - n / 2))), kRounding);
    const MatrixXcd f = MatrixXcd::Random(3, 2), g = MatrixXcd::Random(2, 2);
    MatrixXcd from = b;
    subtract_product(from, a, f);
    EXPECT_LE((from - (b - a * f)).norm(), kRounding);
    from = b;
    subtract_product(from, r, g);
    EXPECT_LE((from - (b - r * g)).norm(), kRounding);
  }
}

// Whole and incomplete tiles. A tile has 3 columns on the left, 4 on the right, 8 rows of a product, and 4 of a sum.
TEST(TallProducts, OfRealMatricesAgreeWithEigen) {
  for (const Eigen::Index n : {1, 3, 4, 11, 100}) {
    for (const Eigen::Index a : {0, 1, 2, 3, 7}) {
      for (const Eigen::Index b : {0, 1, 4, 5}) {
        const MatrixXd left = MatrixXd::Random(n, a), right = MatrixXd::Random(n, b), factors = MatrixXd::Random(a, b);
        EXPECT_LE((tall_transposed_product(left, right) - left.transpose() * right).norm(), kRounding);
        EXPECT_LE((tall_product(left, factors) - left * factors).norm(), kRounding);
      }
    }
  }
}

TEST(TallProducts, OfPartsAreThePartsOfTheProductToTheLastBit) {
  const MatrixXd left = MatrixXd::Random(53, 7), right = MatrixXd::Random(53, 9), factors = MatrixXd::Random(7, 9);
  EXPECT_EQ(tall_transposed_product(left.middleCols(2, 4), right.middleCols(3, 2)),
            tall_transposed_product(left, right).block(2, 3, 4, 2));
  EXPECT_EQ(tall_product(left.middleRows(5, 41), factors.middleCols(3, 2)),
            tall_product(left, factors).block(5, 3, 41, 2));
}

TEST(TallProducts, OfColumnsWithThemselvesAreHermitianToTheLastBit) {
  const MatrixXcd a = MatrixXcd::Random(31, 4);
  const MatrixXcd gram = adjoint_gram(a);
  EXPECT_EQ(gram, MatrixXcd(gram.adjoint()));
}

}  // namespace percuss::tall_products_test
