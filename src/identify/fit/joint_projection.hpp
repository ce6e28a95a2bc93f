#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/math/levenberg_marquardt.hpp"
#include "identify/fit/line_groups.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {

/// The poles of a joint fit, and which modes have real residues.
struct JointModel {
  std::vector<Pole> poles;
  std::vector<char> real;  // [modes] 1: real residues, from a real mode shape and sensors without delay
  bool all_real() const;   // the background's coefficients are then real as well
};

/// The linear part of a joint fit at given poles, for FRFs that share their columns. The rows are weighted frequency
/// groups, real parts above imaginary parts.
struct JointPart {
  std::vector<std::size_t> channels;  // indices into FrfDataset::channels
  std::vector<std::size_t> first;     // [modes] column of the residue's real part; the imaginary part's follows
  Eigen::MatrixXd columns;            // [rows, unknowns per channel]
  Eigen::MatrixXd slopes;      // derivatives of the columns by frequency and damping ratio, two for each residue column
  Eigen::MatrixXd quadrature;  // [rows, modes] column of the residue's imaginary part, fitted or not
  Eigen::MatrixXd inverse;     // of columnsᵀ·columns
  Eigen::MatrixXd amplitude, residual;  // [unknowns, channels] and [rows, channels]
};

struct JointState {
  JointModel model;
  std::vector<JointPart> parts;
  double cost = 0;  // Σ residual²/noise²
};

/// Least squares of all spectral lines of all FRFs at once. The model is the modes and a background of residual terms
/// (out_of_band_terms).
class JointProjection {
 public:
  /// set must outlive this object. `core_share`: see LineGroups.
  JointProjection(const FrfDataset& set, const std::vector<Pole>& poles, double core_share = 0);

  /// Without derivatives, `slopes` and `quadrature` of the parts are empty; amplitudes and residuals are known.
  JointState evaluate(JointModel model, ColumnContent need = ColumnContent::derivatives) const;
  /// Normal equations for a step of the poles, unknowns in the order frequency, damping ratio per mode. Their matrix is
  /// the Fisher information.
  /// theory (4.9)
  NormalEquations normal_equations(const JointState& state) const;
  /// Covariance of the normal equations' right-hand side that the force channel's errors cause, [2 modes, 2 modes].
  Eigen::MatrixXd force_covariance(const JointState& state, ForceErrors of) const;
  /// Variance of each residue (of its real and of its imaginary part) from the force channel's noise, [channels,
  /// modes]. The gain common to the point's FRFs (gain_std) is excluded; the effect through the other modes
  /// remains.
  Eigen::MatrixXd residue_force_variance(const JointState& state) const;

  /// Residues of one FRF of the part over its noise, [slope columns, 2 modes]. `slopes` times this matrix is the
  /// derivative of the FRF over its noise by the poles' unknowns.
  Eigen::MatrixXd residue_matrix(const JointState& state, const JointPart& part, Eigen::Index channel) const;

  /// Takes each FRF's noise, and its course over frequency, from the residual of a fit (its unweighted_residual).
  void weight_by_residual(const JointState& state, const std::vector<Eigen::VectorXcd>& residual);
  /// The residual at every spectral line, without weights: [channels][lines], (m/s²)/N.
  std::vector<Eigen::VectorXcd> unweighted_residual(const JointState& state) const;
  /// [channels] standard deviation of a row.
  const Eigen::VectorXd& noise() const { return noise_; }
  const FrfDataset& set() const { return set_; }

 private:
  // The data of a part: all that does not depend on the poles.
  struct Plan {
    std::vector<std::size_t> channels;
    Eigen::VectorXd weight;      // [lines]
    Eigen::MatrixXd data;        // [rows, channels]
    Eigen::MatrixXd background;  // [rows, terms]
  };
  void fill(Plan& plan) const;
  std::vector<ModeColumn> untruncated_columns(const JointModel& model, ColumnContent need) const;
  JointPart solve(const Plan& plan, const JointModel& model, const std::vector<ModeColumn>& whole) const;
  static void solve_channels(const Plan& plan, Eigen::Index first, Eigen::Index count, JointPart& part);
  void subtract_model(const Eigen::MatrixXcd& columns, const JointPart& part,
                      std::vector<Eigen::VectorXcd>& residual) const;
  void add_force_noise(const JointState& state, const JointPart& part, ForceErrors of,
                       Eigen::MatrixXd& covariance) const;
  void add_residue_variance(const JointState& state, const JointPart& part, Eigen::MatrixXd& variance) const;

  const FrfDataset& set_;
  LineGroups groups_;
  Eigen::MatrixXd background_;  // [lines, terms]
  std::vector<Plan> plans_;
  Eigen::VectorXd noise_;
};

}  // namespace percuss::identify
