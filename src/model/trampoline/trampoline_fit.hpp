#pragma once
#include <array>
#include <optional>
#include <vector>

#include "model/trampoline/ccor_misfit.hpp"
#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// The exponents that a fit leaves at the values of its model.
struct HeldExponents {
  bool stiffness = false;  // a
  bool damping = false;    // b
};

/// The 68 % interval of one exponent: its range over all pairs (a, b) whose chi2 is at most 1 above the minimum.
/// theory (10.6)
struct ExponentInterval {
  double low = 0, high = 0;
};

/// The exponents fitted to measured CCOR, with their standard deviations.
struct ExponentFit {
  double stiffness_exponent = 0, stiffness_exponent_std = 0;  // a; standard deviation 0: held
  double damping_exponent = 0, damping_exponent_std = 0;      // b; standard deviation 0: held
  double correlation = 0;                   // of a and b; near 1: both change the CCOR at all speeds alike
  double damping_exponent_std_given_a = 0;  // for a known a
  double chi2 = 0;                          // Σ ((cor − model)/σ)²
  double chi2_p = 1;  // probability of a chi2 at least as large, if all σ are right; 1 without degrees of freedom
  std::vector<double> model_cor;            // at each measured speed
  std::size_t beyond_std = 0;               // measurements with a residual above their standard deviation
  HeldExponents held;                       // as asked for
  std::vector<Exponents> contour;           // pairs with a chi2 of 1 above its minimum; empty if both are held
  ExponentInterval a_interval, b_interval;  // of the contour
  bool at_limit = false;                    // the search's limits cut off a part of the pairs
  bool determined = true;                   // both intervals are narrower than ± kMaxDeterminedHalfWidth

  Exponents exponents() const { return {stiffness_exponent, damping_exponent}; }
  std::size_t free() const { return (held.stiffness ? 0U : 1U) + (held.damping ? 0U : 1U); }
};

/// An exponent with a wider interval is not determined: Hertz's contact (a = 1/2) differs from a linear one (a = 0) by
/// five times as much.
inline constexpr double kMaxDeterminedHalfWidth = 0.1;

/// Fits a and b of rigid_wall_rebound by weighted least squares (Levenberg–Marquardt) within the limits of CcorMisfit.
/// `model` is the start and holds all other constants, and the held exponents.
/// errors  InputError: fewer different speeds than free exponents; speeds too similar to separate a from b; no
/// convergence.
/// source  [8] in docs/theory/sources.md, 4.4, which tries all combinations
ExponentFit fit_exponents(const Trampoline& model, const std::vector<MeasuredCor>& measured, HeldExponents held = {});

}  // namespace percuss::model
