#pragma once

namespace percuss::model {

/// A ball that hits a rigid bat. The bat rotates about its centre of mass, which moves as well.
struct RigidCollision {
  double ball_mass_kg = 0.145;
  double bat_mass_kg = 0.83;
  double inertia_kgm2 = 0.039;   // of the bat about its centre of mass
  double ball_speed_mps = 67;    // of the ball towards the bat
  double swing_rate_radps = 60;  // of the bat's rotation; positive: the barrel moves towards the ball
  double bat_speed_mps = 0;      // of the bat's centre of mass, towards the ball
  double restitution = 0.55;     // relative speed after / before, at the point of impact
};

/// The effective mass of the bat at z_m from its centre of mass:
///   M_e = M / (1 + M z²/I)                                   (1)
/// theory (11.1)
double effective_mass_kg(const RigidCollision& collision, double z_m);

/// The speed of the bat at z_m, towards the ball: u = V + ω z.                                           (2)
/// theory (11.2)
double swing_speed_mps(const RigidCollision& collision, double z_m);

/// The speed of the ball after the impact, against its initial direction:
///   v' = [v (e M_e − m) + u M_e (1 + e)] / (m + M_e)         (3)
/// source  [10] in docs/theory/sources.md
/// theory (11.3)
double exit_speed_mps(const RigidCollision& collision, double z_m);

struct BestImpact {
  double z_m = 0, exit_speed_mps = 0;
};

/// The position between low_m and high_m (from the centre of mass) with the largest exit speed: the root of the
/// derivative of (3), or an end.
BestImpact best_impact(const RigidCollision& collision, double low_m, double high_m);

}  // namespace percuss::model
