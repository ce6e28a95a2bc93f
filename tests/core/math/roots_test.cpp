#include "core/math/roots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace percuss::roots_test {

using Eigen::Index;
using Eigen::VectorXcd;
using Value = std::complex<double>;

constexpr double kUlp = std::numeric_limits<double>::epsilon();

struct Bracketed {
  const char* name;
  RealFunction f;
  double low, high, root;
};

// Smooth functions with simple roots in closed form.
const std::vector<Bracketed>& simple_roots() {
  static const std::vector<Bracketed> all{
      {"cos x", [](double x) { return std::cos(x); }, 0, 3, std::numbers::pi / 2},
      {"x² − 2", [](double x) { return x * x - 2; }, 0, 2, std::numbers::sqrt2},
      {"1 − ln x", [](double x) { return 1 - std::log(x); }, 1, 100, std::numbers::e},
      {"x³ − x/4", [](double x) { return x * (x * x - 0.25); }, 0.1, 7, 0.5},
      {"1/x − 3", [](double x) { return 1 / x - 3; }, 1e-3, 1e3, 1.0 / 3},
      {"tanh 50(x − 0.3)", [](double x) { return std::tanh(50 * (x - 0.3)); }, -5, 1, 0.3},
      {"x − 1e-9", [](double x) { return x - 1e-9; }, -1e6, 1e6, 1e-9}};
  return all;
}

// f that counts its calls.
RealFunction counted(const RealFunction& f, int& calls) {
  return [&f, &calls](double x) {
    ++calls;
    return f(x);
  };
}

TEST(BracketedRoot, IsNearTheClosedFormToTheLastBits) {
  constexpr double kLastBits = 2 * kUlp;  // of the root: the rounding of f's own argument and value
  for (const Bracketed& one : simple_roots())
    EXPECT_NEAR(bracketed_root(one.f, one.low, one.high), one.root, kLastBits * one.root) << one.name;
}

TEST(BracketedRoot, DoesNotDependOnTheSignOfTheFunction) {
  for (const Bracketed& one : simple_roots()) {
    const auto negative = [&](double x) { return -one.f(x); };
    EXPECT_EQ(bracketed_root(negative, one.low, one.high), bracketed_root(one.f, one.low, one.high)) << one.name;
  }
}

TEST(BracketedRoot, NeedsFewEvaluationsOfASmoothFunction) {
  constexpr int kFew = 40;  // for 1/x over six decades; bisection needs 66
  for (const Bracketed& one : simple_roots()) {
    int calls = 0;
    bracketed_root(counted(one.f, calls), one.low, one.high);
    EXPECT_LE(calls, kFew) << one.name;
  }
}

TEST(BracketedRoot, OfAFlatFunctionIsFoundWithinTheBudget) {
  const RealFunction flat = [](double x) { return std::pow(x - 1, 9); };
  int calls = 0;
  EXPECT_NEAR(bracketed_root(counted(flat, calls), -3, 4), 1, 2 * kUlp);
  EXPECT_LE(calls, kMaxRootEvaluations);
}

TEST(BracketedRoot, MayBeAnyPointWhereTheFunctionIsZero) {
  const auto f = [](double x) { return x < 1 ? x - 1 : std::max(0.0, x - 2); };
  const double root = bracketed_root(f, -5, 9);
  EXPECT_EQ(f(root), 0);
}

TEST(BracketedRoot, IsTheEndWhereTheFunctionIsZero) {
  const auto f = [](double x) { return x * (x - 1); };
  EXPECT_EQ(bracketed_root(f, 0, 0.5), 0);
  EXPECT_EQ(bracketed_root(f, 0.5, 1), 1);
  EXPECT_EQ(bracketed_root(f, 0, 1), 0);
}

TEST(BracketedRoot, IsTheNearerEndWhereTheSignsAgree) {
  const auto f = [](double x) { return x + 1e-18; };
  EXPECT_EQ(bracketed_root(f, 0, 1), 0);
  const auto falling = [](double x) { return 1 + 1e-9 - x; };
  EXPECT_EQ(bracketed_root(falling, 0, 1), 1);
}

TEST(BracketedRoot, StandsNextToAJump) {
  const RealFunction jump = [](double x) { return x < 0.3 ? -1.0 : 2.0; };
  int calls = 0;
  EXPECT_NEAR(bracketed_root(counted(jump, calls), 0, 1), 0.3, kUlp);
  EXPECT_LE(calls, kMaxRootEvaluations);
}

TEST(BracketedRoot, StopsWhereTheFunctionIsNoNumber) {
  const RealFunction broken = [](double x) { return x < 0.9 && x > 0.1 ? std::nan("") : x - 0.5; };
  int calls = 0;
  const double root = bracketed_root(counted(broken, calls), 0, 1);
  EXPECT_TRUE(root >= 0 && root <= 1) << root;
  EXPECT_LE(calls, kMaxRootEvaluations);
}

std::vector<double> samples(const RealFunction& f, const std::vector<double>& x) {
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  return y;
}

TEST(BracketedMaximum, LiesBetweenTheSamples) {
  const auto f = [](double x) { return 3 - std::pow(x - 1.234, 2); };
  const std::vector<double> x{0, 1, 2, 3, 4};
  const MaximumPoint found = bracketed_maximum(f, x, samples(f, x));
  constexpr double kTolerance = 1e-8 * 4;  // as the header states: of the range of x
  EXPECT_NEAR(found.x, 1.234, kTolerance);
  EXPECT_NEAR(found.y, 3, 4 * kUlp);
}

TEST(BracketedMaximum, IsTheLargestSampleAtAnEnd) {
  const auto f = [](double x) { return x; };
  const std::vector<double> x{0, 1, 2};
  EXPECT_EQ(bracketed_maximum(f, x, samples(f, x)).x, 2);
  EXPECT_EQ(bracketed_maximum(f, {5}, {1}).x, 5);
}

TEST(BracketedMaximum, IsTheLargestSampleOnAPlateau) {
  const auto f = [](double x) { return -std::max(0.0, std::abs(x - 1.5) - 0.5); };
  const std::vector<double> x{0, 1, 2, 3};
  const MaximumPoint found = bracketed_maximum(f, x, samples(f, x));
  EXPECT_EQ(found.x, 1);
  EXPECT_EQ(found.y, 0);
}

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

// The largest distance of a value of `truth` from the nearest of `found`.
double distance(const VectorXcd& truth, const VectorXcd& found) {
  double largest = 0;
  for (const Value& root : truth) largest = std::max(largest, (found.array() - root).abs().minCoeff());
  return largest;
}

constexpr double kRounding = 1e-11;  // of coefficients that are sums of up to 20 products

TEST(PolynomialRoots, MatchTheRootsThatMadeThePolynomial) {
  for (const Index n : {1, 2, 3, 8, 20}) {
    const VectorXcd truth = on_rings(n);
    EXPECT_LE(distance(truth, polynomial_roots(coefficients(truth), spiral(n))), kRounding) << n;
    EXPECT_LE(distance(truth, companion_roots(coefficients(truth))), kRounding) << n;
  }
}

TEST(PolynomialRoots, KeepTheOrderOfTheirStarts) {
  const VectorXcd truth = on_rings(12);
  const VectorXcd found = polynomial_roots(coefficients(truth), truth.array() + Value(1e-3, -1e-3));
  EXPECT_LE((found - truth).cwiseAbs().maxCoeff(), kRounding);
}

TEST(PolynomialRoots, AreFoundFromEqualStarts) {
  const VectorXcd truth = on_rings(6);
  EXPECT_LE(distance(truth, polynomial_roots(coefficients(truth), VectorXcd::Constant(6, Value(0.5, 0)))), kRounding);
}

TEST(PolynomialRoots, MayBeZeroOrEqual) {
  const VectorXcd zero = VectorXcd::Zero(3);
  EXPECT_LE(distance(zero, polynomial_roots(coefficients(zero), spiral(3))), 1e-4);  // cube root of rounding
  const VectorXcd twice{{Value(0.5, 0.5), Value(0.5, 0.5)}};
  EXPECT_LE(distance(twice, polynomial_roots(coefficients(twice), spiral(2))), 1e-6);  // square root of rounding
}

TEST(PolynomialRoots, AreNoneForAConstant) {
  EXPECT_EQ(polynomial_roots({}, {}).size(), 0);
  EXPECT_EQ(companion_roots({}).size(), 0);
}

}  // namespace percuss::roots_test
