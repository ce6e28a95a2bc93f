#pragma once
#include <vector>

#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// A measured coefficient of restitution off a rigid cylinder (CCOR).
struct MeasuredCor {
  double speed_mps = 0, cor = 0, cor_std = 0;
};

/// The exponents fitted to measured CCOR, with their standard deviations.
struct ExponentFit {
  double stiffness_exponent = 0, stiffness_exponent_std = 0;  // a
  double damping_exponent = 0, damping_exponent_std = 0;      // b
  double correlation = 0;                                     // of a and b: near 1, because both change the level
  double damping_exponent_std_given_a = 0;                    // for a known a
  double chi2 = 0;                                            // Σ ((cor − model)/σ)²
  std::vector<double> model_cor;                              // at each measured speed
  std::size_t beyond_std = 0;  // measurements with a residual above their standard deviation
};

/// Fits a and b of rigid_wall_rebound by weighted least squares (Levenberg–Marquardt). `model` is the start and holds
/// all other constants.
/// errors  InputError: fewer than two different speeds; speeds too similar to separate a from b; no convergence.
/// source  [8] in docs/theory/sources.md, 4.4, which tries all combinations
ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured);

}  // namespace percuss::model
