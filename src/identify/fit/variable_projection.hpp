#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/math/levenberg_marquardt.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/point_columns.hpp"

namespace percuss::identify {

/// The linear least-squares problem at given poles, for FRFs that share their columns, and its solution. The polynomial
/// is projected out of data and columns.
struct ProjectedPart {
  std::vector<std::size_t> channels;  // indices into FrfDataset::channels
  Eigen::MatrixXcd columns;           // [lines, modes] the modes, the polynomial projected out
  Eigen::MatrixXcd slopes;            // [lines, 2 modes] derivatives by frequency and damping ratio, not projected
  Eigen::MatrixXcd inverse_gram;      // (columnsᴴ·columns)⁻¹
  Eigen::MatrixXcd amplitude;         // [modes, channels of this part]
  Eigen::MatrixXcd residual;          // [lines, channels of this part]
};

struct ProjectedState {
  std::vector<ProjectedPart> parts;
  double cost = 0;  // Σ |residual|²/noise_scale²
};

/// Least squares of the FRFs in a window by modes and a complex polynomial, as a function of the poles alone: residues
/// and polynomial are eliminated. source  [7] in docs/theory/sources.md.
class VariableProjection {
 public:
  /// data[o] holds `count` lines from `first` on; noise_scale [channels]. set must outlive this object.
  VariableProjection(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data, Eigen::VectorXd noise_scale,
                     std::size_t first, std::size_t count, std::size_t polynomial_terms);

  ProjectedState evaluate(const std::vector<Pole>& poles) const;

  /// Normal equations for a step of the poles, two unknowns per mode (Hz, damping ratio). Kaufman's Jacobian: the
  /// derivatives with their projection on the columns removed.
  /// theory (4.9)
  NormalEquations normal_equations(const ProjectedState& state, std::size_t modes) const;

  /// The normal equations of each point's FRFs alone, [points].
  std::vector<NormalEquations> normal_equations_by_point(const ProjectedState& state, std::size_t modes) const;

  /// The normal equations of each FRF alone, [channels].
  std::vector<NormalEquations> normal_equations_by_channel(const ProjectedState& state, std::size_t modes) const;

  /// Projects the polynomial and the columns of a part out of further columns, [lines, …].
  void project_out(const ProjectedPart& part, Eigen::MatrixXcd& further) const;

  /// The slopes of a part with the polynomial and the columns projected out, [lines, 2 modes].
  Eigen::MatrixXcd projected_slopes(const ProjectedPart& part) const;

  /// Replaces noise_scale. A ProjectedState stays valid, except for its cost.
  void set_noise_scale(Eigen::VectorXd noise_scale) { noise_scale_ = std::move(noise_scale); }

  /// Derivatives of an FRF's residues by the poles: −(columns⁺)·slopes·residue, [modes, 2 modes].
  Eigen::MatrixXcd residue_derivatives(const ProjectedPart& part, Eigen::Index channel) const;

 private:
  const std::vector<std::vector<std::size_t>>& channels_with_equal_columns(const std::vector<Pole>& poles) const;
  ProjectedPart solve(const std::vector<std::size_t>& channels, const std::vector<PointColumns>& mode_columns) const;
  void project(Eigen::MatrixXcd& columns) const;
  // `sum_of`: the index of the sum to which an FRF belongs.
  std::vector<NormalEquations> sums_of_normal_equations(const ProjectedState& state, std::size_t modes,
                                                        std::size_t sums,
                                                        const std::function<std::size_t(std::size_t)>& sum_of) const;
  void add_normal_equations(const ProjectedPart& part,
                            const std::function<NormalEquations&(std::size_t)>& sum_of) const;

  const FrfDataset& set_;
  Eigen::MatrixXd polynomial_;  // [lines, terms] orthonormal
  Eigen::MatrixXcd data_;       // [lines, channels] the polynomial projected out
  Eigen::VectorXd noise_scale_;
  std::size_t first_, count_;
  std::vector<std::vector<std::size_t>> by_point_, together_{1};  // the FRFs of each point; all FRFs in one list
};

}  // namespace percuss::identify
