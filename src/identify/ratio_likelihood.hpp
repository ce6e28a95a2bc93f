#pragma once
#include <vector>

namespace percuss {

/// The ratio of two sensors' residues as an angle: χ = atan(A₂/A₁), modulo 180°.
struct RatioAngle {
  double chi_rad = 0;
  double std_rad = 0;
  double out_of_phase = 0;  // |Im|/| · | of the ratio: 0 for a real shape
};

/// Density of a Gaussian of deviation `std` on the circle of 180°, per radian.
double wrapped_density(double difference_rad, double std_rad);

/// How probable an observed χ is for each kind of shape, per radian, for sensors at two angles placed to within
/// `angle_std_rad`.
class RatioLikelihood {
 public:
  RatioLikelihood(double first_rad, double second_rad, double angle_std_rad);

  /// Bending in an unknown plane; `known` holds χ of other modes that bend: this one then lies in one of their planes
  /// or at right angles.
  double bending(const RatioAngle& ratio, const std::vector<double>& known) const;
  /// Hoop, n = 2, turned by any angle.
  double hoop(const RatioAngle& ratio) const;
  /// Anything else: breathing and n = 4 (equal motion of both sensors), n = 3 and local shapes (any ratio); weighted by
  /// its rarity.
  double other(const RatioAngle& ratio) const;

 private:
  double over_all_turns(const RatioAngle& ratio, int n) const;
  double first_rad_, second_rad_, angle_std_rad_;
};

}  // namespace percuss
