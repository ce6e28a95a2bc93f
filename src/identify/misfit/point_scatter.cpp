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

// The contributions of points or of FRFs to the step from the poles to the weighted least squares, [unknowns, parts],
// and the variance of each by noise.
struct Contributions {
  VectorXd step;
  MatrixXd value, variance;
};

Contributions contributions_of(const std::vector<NormalEquations>& parts, Index unknowns) {
  MatrixXd matrix = MatrixXd::Zero(unknowns, unknowns);
  VectorXd right = VectorXd::Zero(unknowns);
  for (const NormalEquations& part : parts) {
    matrix += part.matrix;
    right += part.right;
  }
  const MatrixXd inverse = inverse_gram(matrix);
  const auto count = static_cast<Index>(parts.size());
  Contributions out{.step = inverse * right, .value = MatrixXd(unknowns, count), .variance = MatrixXd(unknowns, count)};
  for (Index p = 0; p < count; ++p) {
    const NormalEquations& part = parts[static_cast<std::size_t>(p)];
    out.value.col(p) = inverse * (part.right - part.matrix * out.step);
    // The real and the imaginary part of the residual each have half of its variance.
    out.variance.col(p) = 0.5 * (inverse * part.matrix * inverse).diagonal();
  }
  return out;
}

// The scatter of the contributions to one unknown. Points near a node contribute nothing, and do not count as degrees
// of freedom.
struct Scatter {
  double std = 0;
  double degrees = 1;
  bool beyond_noise = false;
};

Scatter scatter_of(const VectorXd& contribution, const VectorXd& variance, std::size_t least) {
  double chi2 = 0, squares = 0, sum = 0, sum_of_squares = 0, parts = 0;
  for (Index p = 0; p < contribution.size(); ++p) {
    if (!(variance(p) > 0)) continue;
    ++parts;
    chi2 += contribution(p) * contribution(p) / variance(p);
    squares += contribution(p) * contribution(p);
    sum += variance(p);
    sum_of_squares += variance(p) * variance(p);
  }
  if (parts < static_cast<double>(least)) return {};
  return {.std = std::sqrt(squares * parts / (parts - 1)),
          .degrees = std::max(1.0, sum * sum / sum_of_squares - 1),
          .beyond_noise = chi2_deviate(chi2, parts - 1) > kOnceIn300000};
}

}  // namespace

VectorXd point_scatter_std(const VariableProjection& projection, const ProjectedState& state, std::size_t modes) {
  const auto n = static_cast<Index>(2 * modes);
  const std::vector<NormalEquations> points = projection.normal_equations_by_point(state, modes);
  if (points.size() < kMinScatterPoints) return VectorXd::Zero(n);
  const Contributions of_points = contributions_of(points, n);
  VectorXd std(n);
  for (Index i = 0; i < n; ++i) {
    const Scatter scatter = scatter_of(of_points.value.row(i), of_points.variance.row(i), kMinScatterPoints);
    std(i) = scatter.beyond_noise ? student_factor(scatter.degrees) * scatter.std : 0;
  }
  return std;
}

VectorXd sensor_scatter_std(const VariableProjection& projection, const ProjectedState& state, std::size_t modes) {
  const auto n = static_cast<Index>(2 * modes);
  const Contributions of_frfs = contributions_of(projection.normal_equations_by_channel(state, modes), n);
  VectorXd std = VectorXd::Zero(n);
  // Sensors that see different frequencies see different damping ratios as well, although noise may hide it.
  for (Index f = 0; f < n; f += 2) {
    const auto scatter = [&](Index i) { return scatter_of(of_frfs.value.row(i), of_frfs.variance.row(i), 2); };
    const Scatter of_freq = scatter(f), of_damping = scatter(f + 1);
    if (!of_freq.beyond_noise && !of_damping.beyond_noise) continue;
    std(f) = std::hypot(of_freq.std, of_frfs.step(f));
    std(f + 1) = std::hypot(of_damping.std, of_frfs.step(f + 1));
  }
  return std;
}

}  // namespace percuss::identify
