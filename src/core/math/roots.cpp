#include "core/math/roots.hpp"

#include <gsl/gsl_min.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "core/math/complex.hpp"

namespace percuss {
inline namespace core {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXcd;

constexpr int kMaxAberthSteps = 60;
constexpr int kMaxBrentSteps = 60;
constexpr double kToleranceOfMaximum = 1e-8;  // of the range: within it a smooth maximum is flat to rounding
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

struct Sample {
  double x = 0, y = 0;
};

struct Bracket {
  Sample low, high;

  bool contains(double x) const { return x > low.x && x < high.x; }

  // a and b lie within. Keeps the interval between neighbouring points in which f changes its sign.
  void narrow(Sample a, Sample b) {
    if (b.x < a.x) std::swap(a, b);
    const auto differ = [](const Sample& one, const Sample& other) { return (one.y > 0) != (other.y > 0); };
    if (differ(a, b)) {
      low = a;
      high = b;
    } else if (differ(low, a)) {
      high = a;
    } else {
      low = b;
    }
  }
};

double negated(double x, void* f) { return -(*static_cast<const RealFunction*>(f))(x); }

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

// Newton's step of root i on the polynomial with all other roots divided out. False when the root has
// converged: p, or the step, is within its rounding.
bool improve(const VectorXcd& c, VectorXcd& w, Index i) {
  const Value value = evaluate(c, w(i));
  if (std::abs(value.p) <= value.rounding) return false;
  Complex deflation = 0;
  for (Index j = 0; j < w.size(); ++j) {
    if (j != i) deflation += inverse(w(i) - w(j));
  }
  const Complex step = value.p / (value.slope - times(value.p, deflation));
  w(i) -= step;
  return !(std::abs(step) <= kEpsilon * std::abs(w(i)));
}

}  // namespace

double bracketed_root(const RealFunction& f, double low_x, double high_x) {
  Bracket bracket{.low = {low_x, f(low_x)}, .high = {high_x, f(high_x)}};
  const auto& [low, high] = bracket;
  if (low.y == 0 || high.y == 0 || (low.y > 0) == (high.y > 0))
    return std::abs(low.y) <= std::abs(high.y) ? low.x : high.x;
  double root = high.x;
  for (int evaluations = 2; evaluations + 2 <= kMaxRootEvaluations; evaluations += 2) {
    const double middle_x = low.x + (high.x - low.x) / 2;
    if (!bracket.contains(middle_x)) break;
    const Sample middle{middle_x, f(middle_x)};
    if (middle.y == 0) return middle.x;
    const double left = low.y / middle.y, right = high.y / middle.y;
    const double step = (middle.x - low.x) * (left > right ? 1 : -1) / std::sqrt(1 - left * right);
    const double guess_x = std::isfinite(step) ? std::clamp(middle.x + step, low.x, high.x) : middle.x;
    const Sample guess{guess_x, f(guess_x)};
    if (guess.y == 0) return guess.x;
    if (std::exchange(root, guess.x) == guess.x) break;
    bracket.narrow(middle, guess);
  }
  return root;
}

MaximumPoint bracketed_maximum(const RealFunction& f, const std::vector<double>& x, const std::vector<double>& y) {
  assert(!x.empty() && x.size() == y.size());
  const auto best = static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
  const MaximumPoint sample{.x = x[best], .y = y[best]};
  if (best == 0 || best + 1 == y.size() || !(y[best - 1] < sample.y && y[best + 1] < sample.y)) return sample;
  RealFunction copy = f;
  gsl_function function{.function = negated, .params = &copy};
  const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> brent(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  gsl_min_fminimizer_set_with_values(brent.get(), &function, sample.x, -sample.y, x[best - 1], -y[best - 1],
                                     x[best + 1], -y[best + 1]);
  for (int i = 0; i < kMaxBrentSteps; ++i) {
    if (gsl_min_fminimizer_iterate(brent.get()) != 0) break;
    const double width = gsl_min_fminimizer_x_upper(brent.get()) - gsl_min_fminimizer_x_lower(brent.get());
    if (width < kToleranceOfMaximum * (x.back() - x.front())) break;
  }
  return {.x = gsl_min_fminimizer_x_minimum(brent.get()), .y = -gsl_min_fminimizer_f_minimum(brent.get())};
}

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
  for (int step = 0; step < kMaxAberthSteps; ++step) {
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

}  // namespace core
}  // namespace percuss
