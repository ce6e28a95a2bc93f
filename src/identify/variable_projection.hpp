#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

#include "identify/frf_set.hpp"

namespace percuss {

/// The linear problem of outputs that share their columns, at given poles, and its solution.
struct ProjectedPart {
  std::vector<std::size_t> outputs;  // indices into FrfSet::outputs
  std::vector<ModeColumn> columns;   // [modes]
  Eigen::MatrixXcd basis;            // orthonormal basis of modes and polynomial, [lines, columns]
  Eigen::MatrixXcd triangle;         // columns = basis · triangle
  Eigen::MatrixXcd amplitude;        // [columns, outputs of this part]
  Eigen::MatrixXcd residual;         // [lines, outputs of this part]
};

struct ProjectedState {
  std::vector<ProjectedPart> parts;
  double cost = 0;  // Σ |residual|²/weight²
};

/// Least squares of FRF lines in a window by modes and a complex polynomial, as a function of the poles alone:
/// everything linear is eliminated by QR. source  [7] in docs/sources.md.
class VariableProjection {
 public:
  /// data[o] holds `count` lines from `first` on; weight [outputs]. set and data must outlive this object.
  VariableProjection(const FrfSet& set, const std::vector<Eigen::VectorXcd>& data, Eigen::VectorXd weight,
                     std::size_t first, std::size_t count, std::size_t polynomial_terms);

  ProjectedState evaluate(const std::vector<Pole>& poles) const;

  /// Normal equations (matrix, right-hand side) for a step of the poles, 2 unknowns per mode (Hz, damping ratio), with
  /// Kaufman's Jacobian: what the linear part cannot follow of each derivative.
  std::pair<Eigen::MatrixXd, Eigen::VectorXd> normal_equations(const ProjectedState& state, std::size_t modes) const;

 private:
  const std::vector<std::vector<std::size_t>>& outputs_alike(const std::vector<Pole>& poles) const;
  ProjectedPart solve(const std::vector<std::size_t>& outputs, const std::vector<Pole>& poles) const;

  const FrfSet& set_;
  const std::vector<Eigen::VectorXcd>& data_;
  Eigen::VectorXd weight_;
  std::size_t first_, count_, terms_;
  std::vector<std::vector<std::size_t>> by_point_, together_{1};
};

}  // namespace percuss
