#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Poles that are fitted together, and what the fit says of them.
struct LocalFit {
  std::vector<Pole> poles;      // [modes]
  Eigen::MatrixXcd residues;    // [channels, modes], 1/kg
  Eigen::MatrixXd residue_std;  // of |residue − truth|/√2: each of real and imaginary part; force gain left out
  Eigen::VectorXd freq_std_Hz, damping_std;
  Eigen::VectorXd noise;    // [channels] rms of |residual| per line, (m/s²)/N
  double cost = 0;          // Σ |residual|²/noise-weight², with the weights given
  std::size_t degrees = 0;  // real data minus real parameters
  bool converged = false;
};

struct LocalFitOptions {
  std::size_t first = 0, count = 0;  // the window of lines
  std::size_t residual_terms = 3;    // complex polynomial coefficients for what other modes leave
  int max_steps = 30;
  double tolerance = 1e-7;  // step, in units of half the bandwidth
  double change = 0.01;     // … or what it can still gain, in deviations
};

/// Least squares of the channels' lines in a window by modes with complex residues and a polynomial: poles by
/// Levenberg–Marquardt with an analytic Jacobian, everything linear eliminated (variable projection). Outputs are
/// weighted by 1/weight[o] and, in the end, all deviations are scaled by the residual. shapes  data[o] holds
/// options.count lines (what other modes contribute already subtracted); weight [channels]. source  [7] in
/// docs/theory/sources.md.
/// theory (4.14)
LocalFit fit_locally(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data, const Eigen::VectorXd& weight,
                     std::vector<Pole> start, const LocalFitOptions& options);

/// A first pole from the lines of a window by a linear fit: (jω − s) H = a + b(jω), s common, a and b per channel.
/// freq_Hz is 0 when the lines hold no decaying oscillation.
/// theory (4.2)
Pole pole_of_window(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& data, std::size_t first);

}  // namespace percuss::identify
