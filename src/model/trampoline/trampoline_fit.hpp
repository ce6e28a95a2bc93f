#pragma once
#include <vector>

#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// A measured coefficient of restitution off a rigid cylinder (CCOR).
struct MeasuredCor {
  double speed_mps = 0, cor = 0, cor_std = 0;
};

/// The exponents that explain measured CCOR, with the deviations that the measurement leaves them.
struct ExponentFit {
  double stiffness_exponent = 0, stiffness_exponent_std = 0;  // a
  double damping_exponent = 0, damping_exponent_std = 0;      // b
  double correlation = 0;                                     // of a and b: near 1, since both set the level
  double damping_exponent_std_given_a = 0;                    // were a known
  double chi2 = 0;                                            // Σ ((cor − model)/σ)²
  std::vector<double> model_cor;                              // at each measured speed
  std::size_t beyond_std = 0;  // measurements that the model misses by more than their deviation
};

/// Weighted least squares for a and b of rigid_wall_rebound, the other constants as in `model`, where the search starts
/// too: Gauss–Newton with Marquardt's damping. errors  InputError: fewer than two different speeds; speeds too alike to
/// tell a from b; no exponents fit. source  [8] in docs/theory/sources.md, 4.4: there by trying all combinations
ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured);

}  // namespace percuss::model
