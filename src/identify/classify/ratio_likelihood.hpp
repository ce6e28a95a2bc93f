#pragma once
#include <array>
#include <complex>
#include <cstddef>

namespace percuss::identify {

/// The ratio of two sensors' residues as an angle: χ = atan(A₂/A₁), modulo 180°.
struct RatioAngle {
  double chi_rad = 0;
  double std_rad = 0;
  double out_of_phase = 0;  // 2 |Im(conj(A₁)·A₂)|/(|A₁|² + |A₂|²): 0 for a real shape
};

/// Density of a wrapped Gaussian of standard deviation `std_rad` with period 180°, per radian.
double wrapped_density(double difference_rad, double std_rad);

/// Errors of a set-up made by hand: the standard deviations of one sensor's angle and of one channel's gain.
struct SetUpError {
  double angle_rad = 0.035;  // 2°
  double gain = 0.03;
};

/// The likelihood of an observed χ for each type of shape, per radian, for sensors at two angles. A pattern
/// cos n(θ − θ₀) at a uniformly distributed angle θ₀ gives A₁ + jA₂ = α e^jφ + β e^−jφ with φ uniform. So e^2jχ is a
/// Möbius transform of a uniform phase: its k-th moment is the k-th power of the transform's value μ at the circle's
/// centre (at infinity where |α| < |β|). With a Gaussian of standard deviation s for noise and gains:
///   p(χ) = (1 + 2 Re Σ_k z^k exp(−2 k² s²))/π,  z = e^2jχ conj(μ),  μ = β/conj(α) or α/conj(β), |μ| ≤ 1           (1)
/// Sensors at 90° give |μ| = 0 for bending (any χ) and 1 for n = 2 (χ = −45°). Misplaced
/// sensors blur the peak at −45°.
/// theory (6.4), (6.5)
class RatioLikelihood {
 public:
  /// Quadrature points for the error of the angle between the sensors, which all modes of a test share.
  static constexpr std::size_t kPlacements = 7;
  static double weight_of(std::size_t placement);

  RatioLikelihood(double first_rad, double second_rad, const SetUpError& error);

  /// Bending in any plane.
  double bending(const RatioAngle& ratio) const;
  /// Bending of a bat whose modes mostly lie in this plane or at right angles to it.
  double bending(const RatioAngle& ratio, double plane_rad) const;
  /// Bending of a round tube, whose modes all lie in the plane of the blow, `plane_rad`.
  double bending_of_blow(const RatioAngle& ratio, double plane_rad) const;
  /// Hoop, n = 2, at any angle: for one placement, and summed over all placements.
  double hoop(const RatioAngle& ratio, std::size_t placement) const;
  double hoop(const RatioAngle& ratio) const;
  /// Three waves around the tube, n = 3, at any angle, summed over all placements.
  double three_waves(const RatioAngle& ratio) const;
  /// Other types: breathing and n = 4 (equal motion of both sensors), n = 3 and local shapes (any ratio). Includes the
  /// small prior probability of these types.
  double other(const RatioAngle& ratio) const;

  /// Amplitude at both sensors of a unit pattern of n waves with this ratio: 0 at its nodes, √2 at most.
  double observed_amplitude(const RatioAngle& ratio, int n) const;

 private:
  double chi_std_rad(const RatioAngle& ratio) const;
  double bending_in(const RatioAngle& ratio, double plane_rad, double plane_std_rad) const;
  double density(const RatioAngle& ratio, std::complex<double> mean) const;
  double first_rad_, second_rad_, apart_std_rad_, gain_std_;
  std::complex<double> bending_mean_;
  std::array<std::complex<double>, kPlacements> hoop_mean_;
};

}  // namespace percuss::identify
