#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

namespace percuss {
inline namespace core {

using RealFunction = std::function<double(double)>;

/// The limit of evaluations of bracketed_root. A smooth f needs 10 to 40, a flat one about two for each bit.
inline constexpr int kMaxRootEvaluations = 402;

/// Finds a root of f between low and high by Ridders' method, to the last bits of the root.
///   f is continuous, and its values at low and high have different signs.
///   An end where f is zero is the root.
///   Where both ends have the same sign, the result is the end with the smaller |f|: rounding may move a root that lies
///   at an end across it.
/// The result never leaves the bracket. Where f jumps from one sign to the other, the result is next to the jump.
double bracketed_root(const RealFunction& f, double low, double high);

struct MaximumPoint {
  double x = 0, y = 0;
};

/// Finds a maximum of f near the largest of its samples y at x by Brent's method (GSL), to 1e-8 of the range of x.
/// The bracket is the largest sample and its two neighbours. The largest sample itself is the result where it is the
/// first or the last, or where a neighbour equals it.
/// shapes  x ascending, y of the same length, at least one sample; f is finite within the bracket.
MaximumPoint bracketed_maximum(const RealFunction& f, const std::vector<double>& x, const std::vector<double>& y);

/// Finds all roots of w^n + c_1 w^(n−1) + … + c_n by Aberth's simultaneous Newton iteration.
///   start: n different values. The roots of a similar polynomial converge in a few steps.
///   Where the iteration does not converge, the result is companion_roots(c).
/// Result i belongs to start i, except for the result of companion_roots.
/// shapes  c, start and result [n].
Eigen::VectorXcd polynomial_roots(const Eigen::VectorXcd& c, const Eigen::VectorXcd& start);

/// Finds the same roots as the eigenvalues of the companion matrix. Needs no start, but about thirty times the work.
Eigen::VectorXcd companion_roots(const Eigen::VectorXcd& c);

}  // namespace core
}  // namespace percuss
