#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The fit of all modes together to all spectral lines of all FRFs.
struct JointFit {
  std::vector<Pole> poles;                   // in the order of the start; close poles may have exchanged places
  std::vector<char> real;                    // [modes] 1 where the mode's residues are real
  Eigen::MatrixXcd residues;                 // [channels, modes], 1/kg
  Eigen::MatrixXd residue_std;               // of real and imaginary part, without the force's gain error
  Eigen::VectorXd freq_std_Hz, damping_std;  // including the force's noise
  std::vector<Eigen::VectorXcd> residual;    // [channels][lines], (m/s²)/N
  bool converged = false;
  int trials = 0;  // evaluations of the model
};

struct JointFitOptions {
  /// Called once with the residual of the fit with complex residues, [channels][lines]. Where it returns false, the fit
  /// ends as not converged.
  std::function<bool(const std::vector<Eigen::VectorXcd>& residual)> worth_continuing;
  int max_steps = 20;
  double tolerance = 1e-7;      // of a step, see normalised_step
  double cost_tolerance = 0;    // relative: a smaller expected decrease of the squares ends the fit too
  double core_share = 0;        // see LineGroups
  int max_small_decreases = 0;  // see LevenbergMarquardtOptions
  bool test_real = true;        // false: all residues stay complex, at a fraction of the work
  std::vector<Pole> held{};     // equal to poles of the start, which do not move; their std is as of free poles
};

/// Maximum likelihood fit of H1 estimates with noise on the response. Poles are found by Levenberg–Marquardt with an
/// analytic Jacobian; residues and background are eliminated. A mode's residues are real where this gives the smaller
/// standard deviation of the frequency and the data do not contradict it; complex residues absorb the phase error that
/// the force's noise causes. Standard deviations come from the Fisher information, scaled by the residual, plus the
/// effect of the force's noise on the poles (errors in variables).
/// source  [5], [7] in docs/theory/sources.md.
/// theory (4.8), (4.12), (4.13)
JointFit fit_jointly(const FrfDataset& set, std::vector<Pole> start, const JointFitOptions& options = {});

/// The complex residues of all FRFs at given poles, with their standard deviations. `covariance` belongs to the poles,
/// in the order frequency, damping ratio per mode.
JointFit fit_residues(const FrfDataset& set, const std::vector<Pole>& poles, const Eigen::MatrixXd& covariance);

/// The same where the poles are taken for exact.
JointFit fit_residues(const FrfDataset& set, const std::vector<Pole>& poles);

/// The same residues without standard deviations, [channels, modes], at a fraction of the work.
Eigen::MatrixXcd residues_at(const FrfDataset& set, const std::vector<Pole>& poles);

}  // namespace percuss::identify
