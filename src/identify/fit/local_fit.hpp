#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// The fit of a few poles over a window of spectral lines.
struct LocalFit {
  std::vector<Pole> poles;    // [modes]
  Eigen::MatrixXcd residues;  // [channels, modes], 1/kg
  Eigen::MatrixXd residue_std;  // of real and imaginary part, rms |residue − truth|/√2, without the force's gain error
  Eigen::VectorXd freq_std_Hz, damping_std;
  Eigen::VectorXd noise;    // [channels] rms of |residual| per line, (m/s²)/N
  double cost = 0;          // Σ |residual|²/noise_scale²
  std::size_t degrees = 0;  // of freedom: real data minus real parameters
  bool converged = false;
};

struct LocalFitOptions {
  std::size_t first = 0, count = 0;  // the window, in lines
  std::size_t residual_terms = 3;    // complex coefficients of the polynomial that stands for the other modes
  int max_steps = 30;
  double tolerance = 1e-7;  // of a step, see normalised_step
  // Expected change of the poles, in standard deviations. Either tolerance ends the fit.
  double change_tolerance = 0.01;
};

/// Least squares of all FRFs in a window by modes with complex residues and a polynomial. Poles are found by
/// Levenberg–Marquardt with an analytic Jacobian; residues and polynomial are eliminated (variable projection). The
/// residuals of FRF o are divided by noise_scale[o], for example the rms of its noise. All standard deviations are
/// scaled by the residual. shapes  data[o] holds options.count lines, the other modes' contributions subtracted;
/// noise_scale [channels]. source  [7] in docs/theory/sources.md. theory (4.14)
LocalFit fit_locally(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data,
                     const Eigen::VectorXd& noise_scale, std::vector<Pole> start, const LocalFitOptions& options);

/// A start value of a pole, by a linear fit over a window: (jω − s)·H = a + b·jω, with one s for all FRFs, and a and b
/// per FRF. freq_Hz is 0 where the window holds no decaying oscillation. theory (4.2)
Pole pole_of_window(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data, std::size_t first);

}  // namespace percuss::identify
