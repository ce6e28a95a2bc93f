#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/math/levenberg_marquardt.hpp"
#include "identify/fit/frequency_bins.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/noise/force_noise.hpp"

namespace percuss::identify {

/// Which poles a joint fit works with, and whose residues are real.
struct JointModel {
  std::vector<Pole> poles;
  std::vector<char> real;  // [modes] residue without imaginary part: a real mode shape, sensors without delay
  bool all_real() const;   // then the background's coefficients are real as well
};

/// The linear part of a joint fit at given poles, for channels that share their columns. Rows are weighted blocks of
/// lines, real above imaginary parts.
struct JointPart {
  std::vector<std::size_t> channels;    // indices into FrfDataset::channels
  std::vector<std::size_t> first;       // [modes] column of the residue's real part; the imaginary part's follows
  Eigen::MatrixXd columns;              // [rows, unknowns per channel]
  Eigen::MatrixXd slopes;               // of the columns along frequency and damping, two for each residue column
  Eigen::MatrixXd quadrature;           // [rows, modes] a residue's imaginary part, whether fitted or not
  Eigen::MatrixXd inverse;              // of columnsᵀ·columns
  Eigen::MatrixXd amplitude, residual;  // [unknowns, channels], [rows, channels]
};

struct JointState {
  JointModel model;
  std::vector<JointPart> parts;
  double cost = 0;  // Σ residual²/noise²
};

/// Least squares of all lines of all channels at once by modes and a background: mass line, and guard modes at fixed
/// places for what lies beyond the lines.
class JointProjection {
 public:
  /// set must outlive this object.
  JointProjection(const FrfDataset& set, const std::vector<Pole>& poles);

  JointState evaluate(JointModel model) const;
  /// Normal equations for a step of the poles, unknowns in the order frequency, damping ratio per mode. Their matrix is
  /// the Fisher information.
  /// theory (4.9)
  NormalEquations normal_equations(const JointState& state) const;
  /// Covariance of the normal equations' right-hand side that the force channel's errors cause, [2 modes, 2 modes].
  Eigen::MatrixXd force_covariance(const JointState& state, ForceErrors of) const;
  /// Variance of each residue (of its real and imaginary part) that the force channel's noise causes beyond the gain
  /// common to the point's responses (gain_deviation): what it makes of the other modes. [channels, modes]
  Eigen::MatrixXd residue_force_variance(const JointState& state) const;

  /// From slope columns to the unknowns of the poles, with the residues of a channel of the part, in units of its
  /// noise.
  Eigen::MatrixXd spread_of(const JointState& state, const JointPart& part, Eigen::Index channel) const;

  /// Takes each channel's noise, and how the noise goes with frequency, from what a fit left (its unweighted_residual).
  void weight_by_residual(const JointState& state, const std::vector<Eigen::VectorXcd>& left);
  /// What the fit leaves of every line, not weighted: [channels][lines], (m/s²)/N.
  std::vector<Eigen::VectorXcd> unweighted_residual(const JointState& state) const;
  /// [channels] deviation of a row.
  const Eigen::VectorXd& noise() const { return noise_; }
  const FrfDataset& set() const { return set_; }

 private:
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
  void subtract_shares(const Eigen::MatrixXcd& columns, const JointPart& part,
                       std::vector<Eigen::VectorXcd>& left) const;
  void add_force_noise(const JointState& state, const JointPart& part, ForceErrors of,
                       Eigen::MatrixXd& covariance) const;
  void add_residue_variance(const JointState& state, const JointPart& part, Eigen::MatrixXd& variance) const;

  const FrfDataset& set_;
  FrequencyBins blocks_;
  Eigen::MatrixXd background_;  // [lines, terms]
  std::vector<Plan> parts_;
  Eigen::VectorXd noise_;
};

}  // namespace percuss::identify
