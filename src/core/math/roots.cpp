#include "core/math/roots.hpp"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <complex>
#include <limits>
#include <vector>

#include "core/math/complex.hpp"

namespace percuss::inline core {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

constexpr int kMaxSteps = 60;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Value {
  Complex p, slope;
  double rounding = 0;  // of p
};

Value evaluate(const VectorXcd& c, Complex w) {
  Value value{.p = 1, .slope = 0, .rounding = 1};
  const double size = std::abs(w);
  for (const Complex& coefficient : c) {
    value.slope = times(value.slope, w) + value.p;
    value.p = times(value.p, w) + coefficient;
    value.rounding = value.rounding * size + std::abs(value.p.real()) + std::abs(value.p.imag());
  }
  value.rounding *= 4 * kEpsilon;
  return value;
}

// Newton's step of root i on the polynomial with all other roots divided out; false when p is no more than rounding.
bool improve(const VectorXcd& c, VectorXcd& w, Index i) {
  const Value value = evaluate(c, w(i));
  if (std::abs(value.p) <= value.rounding) return false;
  Complex pull = 0;
  for (Index j = 0; j < w.size(); ++j) {
    if (j != i) pull += inverse(w(i) - w(j));
  }
  const Complex step = value.p / (value.slope - times(value.p, pull));
  w(i) -= step;
  return !(std::abs(step) <= kEpsilon * std::abs(w(i)));
}

}  // namespace

Eigen::VectorXcd companion_roots(const Eigen::VectorXcd& c) {
  const Index n = c.size();
  if (n == 0) return {};
  Eigen::MatrixXcd companion = Eigen::MatrixXcd::Zero(n, n);
  companion.row(0) = -c.transpose();
  companion.diagonal(-1).setOnes();
  Eigen::ComplexSchur<Eigen::MatrixXcd> schur(n);
  schur.computeFromHessenberg(companion, Eigen::MatrixXcd(), false);
  return schur.matrixT().diagonal();
}

Eigen::VectorXcd polynomial_roots(const Eigen::VectorXcd& c, const Eigen::VectorXcd& start) {
  assert(c.size() == start.size());
  VectorXcd w = start;
  std::vector<char> moving(static_cast<std::size_t>(w.size()), 1);
  for (int step = 0; step < kMaxSteps; ++step) {
    bool any = false;
    for (Index i = 0; i < w.size(); ++i) {
      char& moves = moving[static_cast<std::size_t>(i)];
      if (moves) moves = improve(c, w, i) ? 1 : 0;
      any = any || moves;
    }
    if (!any) return w.allFinite() ? w : companion_roots(c);
  }
  return companion_roots(c);
}

}  // namespace percuss::inline core
