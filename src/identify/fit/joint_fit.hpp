#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// All modes fitted together to all lines of all channels.
struct JointFit {
  std::vector<Pole> poles;                   // in the order of the start; close ones may have changed places
  std::vector<char> real;                    // [modes] the residues are real
  Eigen::MatrixXcd residues;                 // [channels, modes], 1/kg
  Eigen::MatrixXd residue_std;               // of real and imaginary part; force gain left out
  Eigen::VectorXd freq_std_Hz, damping_std;  // the force's noise included
  std::vector<Eigen::VectorXcd> residual;    // [channels][lines] what the fit leaves, (m/s²)/N
  bool converged = false;
};

struct JointFitOptions {
  /// Asked once with what complex residues leave of all lines, [channels][lines]; false ends the fit as not converged.
  std::function<bool(const std::vector<Eigen::VectorXcd>& left)> worth_continuing;
  int max_steps = 20;
  double tolerance = 1e-7;  // step, in units of half the bandwidth
};

/// Maximum likelihood of H1 lines whose noise is that of the response: poles by Levenberg–Marquardt with an analytic
/// Jacobian, everything linear eliminated. Real and complex residues compete: a mode's residues are real where that
/// leaves the smaller deviation (a complex one absorbs the phase error that the force's noise causes) and the lines do
/// not contradict it. Deviations come from the Fisher information, scaled by the residual; what the force's noise does
/// to the poles is added (errors in variables). source  [5], [7] in docs/theory/sources.md.
/// theory (4.8), (4.12), (4.13)
JointFit fit_jointly(const FrfDataset& set, std::vector<Pole> start, const JointFitOptions& options = {});

/// The residues of all channels at given poles, complex, with their deviations; `covariance` is the poles', unknowns in
/// the order frequency, damping ratio per mode.
JointFit fit_residues(const FrfDataset& set, const std::vector<Pole>& poles, const Eigen::MatrixXd& covariance);

/// … and without, [channels, modes]: at a fraction of the work.
Eigen::MatrixXcd residues_at(const FrfDataset& set, const std::vector<Pole>& poles);

}  // namespace percuss::identify
