#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// A measured coefficient of restitution off a rigid cylinder (CCOR).
struct MeasuredCor {
  double speed_mps = 0, cor = 0, cor_std = 0;
};

/// The exponents [a, b] of the ball's stiffness and damping.
using Exponents = Eigen::Vector2d;

/// `model` with these exponents.
Trampoline with_exponents(Trampoline model, const Exponents& e);

/// Fits search 0 ≤ a ≤ kMaxStiffnessExponent: a ball's contact stiffens (Hertz: a = 1/2). With a larger a the contact
/// would act like a hard stop, as no ball does.
inline constexpr double kMaxStiffnessExponent = 3;
inline constexpr double kStartMargin = 1e-3;  // distance from b to its limit 1 + a at which a search starts or ends

/// The weighted misfit of the model's CCOR to measured values, as a function of the exponents.
/// theory (10.5)
class CcorMisfit {
 public:
  /// `model` holds all other constants.
  CcorMisfit(const Trampoline& model, const std::vector<MeasuredCor>& measured) : model_(model), measured_(measured) {}

  /// Whether a fit may take these exponents: 0 ≤ a ≤ kMaxStiffnessExponent, 0 ≤ b < 1 + a.
  static bool is_usable(const Exponents& e);

  double cor(const Exponents& e, double speed_mps) const;
  /// (cor − model)/σ of each measurement
  Eigen::VectorXd residual(const Exponents& e) const;
  /// Its derivatives with respect to a and b, [measurements, 2].
  Eigen::MatrixXd jacobian(const Exponents& e) const;
  double chi2(const Exponents& e) const { return residual(e).squaredNorm(); }

  /// Minimises chi2 over the free exponents, from `start`, within the usable ones.
  /// errors  InputError: no convergence.
  Exponents minimum(const Exponents& start, const std::array<bool, 2>& free) const;

  /// The pair of the least chi2 with this a. The search starts from the b of `near`, lowered if necessary so that the
  /// dashpot releases the ball.
  /// errors  InputError: no convergence.
  Exponents best_with_a(double a, const Exponents& near) const;

  /// The range of exponent `varied` over which no residual exceeds 1, with the other exponent as in `at`. Nothing where
  /// some residual always exceeds 1.
  std::optional<std::array<double, 2>> range_within_std(const Exponents& at, int varied) const;

  const std::vector<MeasuredCor>& measured() const { return measured_; }

 private:
  Trampoline model_;
  const std::vector<MeasuredCor>& measured_;
};

}  // namespace percuss::model
