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

TEST(TallProducts, OfColumnsWithThemselvesAreHermitianToTheLastBit) {
  const MatrixXcd a = MatrixXcd::Random(31, 4);
  const MatrixXcd gram = adjoint_gram(a);
  EXPECT_EQ(gram, MatrixXcd(gram.adjoint()));
}

}  // namespace percuss::tall_products_test
