#pragma once
#include <array>
#include <complex>
#include <cstddef>

namespace percuss::identify {

/// The ratio of two sensors' residues as an angle: χ = atan(A₂/A₁), modulo 180°.
struct RatioAngle {
  double chi_rad = 0;
  double std_rad = 0;
  double out_of_phase = 0;  // |Im|/| · | of the ratio: 0 for a real shape
};

/// Density of a Gaussian of deviation `std` on the circle of 180°, per radian.
double wrapped_density(double difference_rad, double std_rad);

/// How well a test is set up by hand: deviations of one sensor's place and of one channel's gain.
struct SetUpError {
  double angle_rad = 0.035;  // 2°
  double gain = 0.03;
};

/// How probable an observed χ is for each kind of shape, per radian, for sensors at two angles. A pattern cos n(θ − θ₀)
/// of unknown turn θ₀ gives the residues Re(α e^jφ + β e^−jφ) with φ uniform, so that e^2jχ is a Möbius transform of a
/// uniform phase: its k-th moment is the k-th power of the transform's value μ at the circle's centre (or at infinity,
/// where |α| < |β|). With a Gaussian of deviation s for noise and gains:
///   p(χ) = (1 + 2 Re Σ_k z^k exp(−2 k² s²))/π,  z = e^2jχ conj(μ),  μ = β/conj(α) or α/conj(β), |μ| ≤ 1           (1)
/// Sensors at 90° give |μ| = 0 for bending (any χ) and 1 for n = 2 (χ = −45°); misplaced ones blur the latter.
/// theory (6.4), (6.5)
class RatioLikelihood {
 public:
  /// By how much the sensors' distance is off, as a few values with a Gaussian's weights. All modes of a test share it.
  static constexpr std::size_t kPlacements = 7;
  static double weight_of(std::size_t placement);

  RatioLikelihood(double first_rad, double second_rad, const SetUpError& error);

  /// Bending in any plane.
  double bending(const RatioAngle& ratio) const;
  /// Bending of a bat that is weakest in this plane: most of its modes lie in it or at right angles to it.
  double bending(const RatioAngle& ratio, double plane_rad) const;
  /// Hoop, n = 2, turned by any angle: for one placement, and over all of them.
  double hoop(const RatioAngle& ratio, std::size_t placement) const;
  double hoop(const RatioAngle& ratio) const;
  /// Anything else: breathing and n = 4 (equal motion of both sensors), n = 3 and local shapes (any ratio); weighted by
  /// its rarity.
  double other(const RatioAngle& ratio) const;

  /// What both sensors together see of a pattern of n waves that gives this ratio: 0 on its nodes, √2 at most.
  double seen(const RatioAngle& ratio, int n) const;

 private:
  double deviation(const RatioAngle& ratio) const;
  double density(const RatioAngle& ratio, std::complex<double> mean) const;
  double first_rad_, second_rad_, apart_std_rad_, gain_std_;
  std::complex<double> bending_mean_;
  std::array<std::complex<double>, kPlacements> hoop_mean_;
};

}  // namespace percuss::identify
