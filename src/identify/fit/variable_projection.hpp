#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/math/levenberg_marquardt.hpp"
#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The linear problem of channels that share their columns, at given poles, and its solution. The polynomial is
/// projected out of everything.
struct ProjectedPart {
  std::vector<std::size_t> channels;  // indices into FrfDataset::channels
  Eigen::MatrixXcd columns;           // [lines, modes] what the polynomial cannot follow of each mode
  Eigen::MatrixXcd slopes;            // [lines, 2 modes] of the modes by frequency and damping ratio, not projected
  Eigen::MatrixXcd inverse_gram;      // (columnsᴴ·columns)⁻¹
  Eigen::MatrixXcd amplitude;         // [modes, channels of this part]
  Eigen::MatrixXcd residual;          // [lines, channels of this part]
};

struct ProjectedState {
  std::vector<ProjectedPart> parts;
  double cost = 0;  // Σ |residual|²/weight²
};

/// Least squares of FRF lines in a window by modes and a complex polynomial, as a function of the poles alone:
/// everything linear is eliminated. source  [7] in docs/theory/sources.md.
class VariableProjection {
 public:
  /// data[o] holds `count` lines from `first` on; weight [channels]. set must outlive this object.
  VariableProjection(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data, Eigen::VectorXd weight,
                     std::size_t first, std::size_t count, std::size_t polynomial_terms);

  ProjectedState evaluate(const std::vector<Pole>& poles) const;

  /// Normal equations for a step of the poles, 2 unknowns per mode (Hz, damping ratio), with
  /// Kaufman's Jacobian: what the linear part cannot follow of each derivative.
  /// theory (4.9)
  NormalEquations normal_equations(const ProjectedState& state, std::size_t modes) const;

  /// How the residues of a channel follow the poles: −(columns⁺)·slopes·residue, [modes, 2 modes].
  Eigen::MatrixXcd residue_moves(const ProjectedPart& part, Eigen::Index channel) const;

 private:
  const std::vector<std::vector<std::size_t>>& channels_alike(const std::vector<Pole>& poles) const;
  ProjectedPart solve(const std::vector<std::size_t>& channels, const std::vector<Pole>& poles) const;
  void project(Eigen::MatrixXcd& columns) const;

  const FrfDataset& set_;
  Eigen::MatrixXd polynomial_;  // [lines, terms] orthonormal
  Eigen::MatrixXcd data_;       // [lines, channels] the polynomial projected out
  Eigen::VectorXd weight_;
  std::size_t first_, count_;
  std::vector<std::vector<std::size_t>> by_point_, together_{1};
};

}  // namespace percuss::identify
