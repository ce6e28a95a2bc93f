#include "identify/misfit/point_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/linear_algebra.hpp"
#include "core/math/significance.hpp"

namespace percuss::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The standard deviation of an unknown from the scatter of the points' contributions; 0 where the noise explains it.
// `variance`: of each contribution, by the noise.
double std_of(const VectorXd& contribution, const VectorXd& variance) {
  double chi2 = 0, squares = 0, sum = 0, sum_of_squares = 0, points = 0;
  for (Index p = 0; p < contribution.size(); ++p) {
    if (!(variance(p) > 0)) continue;
    ++points;
    chi2 += contribution(p) * contribution(p) / variance(p);
    squares += contribution(p) * contribution(p);
    sum += variance(p);
    sum_of_squares += variance(p) * variance(p);
  }
  if (points < kMinScatterPoints || !(chi2_deviate(chi2, points - 1) > kOnceIn300000)) return 0;
  // Points near a node contribute nothing, and do not count as degrees of freedom.
  const double degrees = std::max(1.0, sum * sum / sum_of_squares - 1);
  return student_factor(degrees) * std::sqrt(squares * points / (points - 1));
}

}  // namespace

VectorXd point_scatter_std(const VariableProjection& projection, const ProjectedState& state, std::size_t modes) {
  const auto n = static_cast<Index>(2 * modes);
  const std::vector<NormalEquations> points = projection.normal_equations_by_point(state, modes);
  if (points.size() < kMinScatterPoints) return VectorXd::Zero(n);
  MatrixXd matrix = MatrixXd::Zero(n, n);
  VectorXd right = VectorXd::Zero(n);
  for (const NormalEquations& point : points) {
    matrix += point.matrix;
    right += point.right;
  }
  const MatrixXd inverse = inverse_gram(matrix);
  const VectorXd step = inverse * right;
  const auto count = static_cast<Index>(points.size());
  MatrixXd contribution(n, count), variance(n, count);
  for (Index p = 0; p < count; ++p) {
    const NormalEquations& point = points[static_cast<std::size_t>(p)];
    contribution.col(p) = inverse * (point.right - point.matrix * step);
    // The real and the imaginary part of the residual each have half of its variance.
    variance.col(p) = 0.5 * (inverse * point.matrix * inverse).diagonal();
  }
  VectorXd std(n);
  for (Index i = 0; i < n; ++i) std(i) = std_of(contribution.row(i), variance.row(i));
  return std;
}

}  // namespace percuss::identify
