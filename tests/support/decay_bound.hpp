#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::test {

/// Free decays Σ Re(amplitude · exp(s t)) in several rows, each with white noise.
struct NoisyDecays {
  std::vector<identify::Pole> poles;
  std::vector<std::vector<Complex>> amplitude;  // [mode][row]
  std::vector<double> noise_std;                // of each row
  double fs_Hz = 0;
  std::size_t samples = 0;  // of each row
};

/// The Cramér–Rao bound of (Re s, Im s) of each mode, in rad²/s², from the derivatives of the samples with respect to
/// all unknowns: the poles, and the complex amplitudes in each row. A square matrix with two rows for each mode.
Eigen::MatrixXd decay_bound(const NoisyDecays& decays);

}  // namespace percuss::test
