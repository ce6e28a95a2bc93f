#include "core/math/roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <vector>

namespace percuss::roots_test {

using Eigen::Index;
using Eigen::VectorXcd;
using Value = std::complex<double>;

// Coefficients below the leading one of Π (w − root).
VectorXcd coefficients(const VectorXcd& roots) {
  VectorXcd c = VectorXcd::Zero(roots.size() + 1);
  c(0) = 1;
  for (Index i = 0; i < roots.size(); ++i) {
    for (Index k = i + 1; k > 0; --k) c(k) -= roots(i) * c(k - 1);
  }
  return c.tail(roots.size());
}

VectorXcd on_rings(Index count) {
  VectorXcd roots(count);
  for (Index i = 0; i < count; ++i) roots(i) = std::polar(i % 2 == 0 ? 1.001 : 0.7, 2.1 * static_cast<double>(i));
  return roots;
}

VectorXcd spiral(Index count) {
  VectorXcd start(count);
  for (Index i = 0; i < count; ++i) start(i) = std::polar(0.6, 2.39996 * static_cast<double>(i + 1));
  return start;
}

// Of each value of `truth` the distance to the nearest of `found`, the largest.
double distance(const VectorXcd& truth, const VectorXcd& found) {
  double largest = 0;
  for (const Value& root : truth) largest = std::max(largest, (found.array() - root).abs().minCoeff());
  return largest;
}

constexpr double kRounding = 1e-11;  // of coefficients that are sums of up to 20 products

TEST(PolynomialRoots, AreThoseThePolynomialWasMadeOf) {
  for (const Index n : {1, 2, 3, 8, 20}) {
    const VectorXcd truth = on_rings(n);
    EXPECT_LE(distance(truth, polynomial_roots(coefficients(truth), spiral(n))), kRounding) << n;
    EXPECT_LE(distance(truth, companion_roots(coefficients(truth))), kRounding) << n;
  }
}

TEST(PolynomialRoots, StandWhereTheirStartsStood) {
  const VectorXcd truth = on_rings(12);
  const VectorXcd found = polynomial_roots(coefficients(truth), truth.array() + Value(1e-3, -1e-3));
  EXPECT_LE((found - truth).cwiseAbs().maxCoeff(), kRounding);
}

TEST(PolynomialRoots, AreFoundFromStartsThatCoincide) {
  const VectorXcd truth = on_rings(6);
  EXPECT_LE(distance(truth, polynomial_roots(coefficients(truth), VectorXcd::Constant(6, Value(0.5, 0)))), kRounding);
}

TEST(PolynomialRoots, MayBeZeroOrEqual) {
  const VectorXcd zero = VectorXcd::Zero(3);
  EXPECT_LE(distance(zero, polynomial_roots(coefficients(zero), spiral(3))), 1e-4);  // the third root of rounding
  const VectorXcd twice{{Value(0.5, 0.5), Value(0.5, 0.5)}};
  EXPECT_LE(distance(twice, polynomial_roots(coefficients(twice), spiral(2))), 1e-6);  // the square root of rounding
}

TEST(PolynomialRoots, OfAConstantAreNone) {
  EXPECT_EQ(polynomial_roots({}, {}).size(), 0);
  EXPECT_EQ(companion_roots({}).size(), 0);
}

}  // namespace percuss::roots_test
