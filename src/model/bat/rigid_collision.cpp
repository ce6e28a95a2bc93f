#include "model/bat/rigid_collision.hpp"

#include <cmath>

namespace percuss::model {

double effective_mass_kg(const RigidCollision& c, double z_m) {
  return c.bat_mass_kg / (1 + c.bat_mass_kg * z_m * z_m / c.inertia_kgm2);  // (1)
}

double swing_speed_mps(const RigidCollision& c, double z_m) {
  return c.bat_speed_mps + c.swing_rate_radps * z_m;  // (2)
}

double exit_speed_mps(const RigidCollision& c, double z_m) {
  const double mass = effective_mass_kg(c, z_m);
  return (c.ball_speed_mps * (c.restitution * mass - c.ball_mass_kg) +
          swing_speed_mps(c, z_m) * mass * (1 + c.restitution)) /
         (mass + c.ball_mass_kg);  // (3)
}

BestImpact best_impact(const RigidCollision& c, double low_m, double high_m) {
  // (3) with (1), numerator and denominator times I + M z², is (n0 + n1 z + n2 z²) / (d0 + d2 z²). The cubic terms of
  // its derivative cancel, so the derivative is zero where a z² + 2 b z + f = 0.
  const double mi = c.bat_mass_kg * c.inertia_kgm2, mm = c.ball_mass_kg * c.bat_mass_kg;
  const double n0 = c.ball_speed_mps * (c.restitution * mi - c.ball_mass_kg * c.inertia_kgm2) +
                    c.bat_speed_mps * mi * (1 + c.restitution);
  const double n1 = c.swing_rate_radps * mi * (1 + c.restitution), n2 = -c.ball_speed_mps * mm;
  const double d0 = mi + c.ball_mass_kg * c.inertia_kgm2, d2 = mm;
  const double a = -n1 * d2, b = n2 * d0 - n0 * d2, f = n1 * d0;
  BestImpact best{.z_m = low_m, .exit_speed_mps = exit_speed_mps(c, low_m)};
  const auto offer = [&](double z_m) {
    if (!(z_m >= low_m && z_m <= high_m)) return;  // also false for NaN, where there is no root
    const double speed = exit_speed_mps(c, z_m);
    if (speed > best.exit_speed_mps) best = {.z_m = z_m, .exit_speed_mps = speed};
  };
  offer(high_m);
  if (a == 0) offer(b == 0 ? low_m : -f / (2 * b));
  const double root = std::sqrt(b * b - a * f);  // real, because a and f differ in sign
  // Both roots without cancellation: one from the sum of like signs, the other from the product of the roots.
  const double sum = -(b + std::copysign(root, b));
  offer(sum / a);
  offer(f / sum);
  return best;
}

}  // namespace percuss::model
