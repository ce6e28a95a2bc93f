#pragma once
#include <Eigen/Core>
#include <vector>

#include "model/bat/bat_modes.hpp"
#include "model/bat/rigid_collision.hpp"

namespace percuss::model {

/// A ball as a spring that gives back less than it took:
///   F = k₁ u^α where u is as large as it has ever been, else F = k₂ u^β,                               (1)
///   β = (1 + α)/e₀² − 1, k₂ such that F is continuous at the largest u                                 (2)
/// whatever the speed, e₀² of the energy comes back. After leaving the bat the ball is as before.
/// source  [10] in docs/theory/sources.md, after Cross and Nathan
/// theory (12.3), (12.4)
struct LossyBall {
  double mass_kg = 0.145;
  double stiffness = 6.53e7;  // k₁, N/m^α
  double exponent = 1.84;     // α, at least 1
  double restitution = 0.5;   // e₀, above 0, at most 1

  double force_N(double u_m, double largest_m) const;
};

struct BatCollision {
  LossyBall ball;
  double ball_speed_mps = 67;    // towards the bat
  double bat_speed_mps = 0;      // of its centre of mass, towards the ball
  double swing_rate_radps = 60;  // about its centre of mass; the barrel goes towards the ball
};

/// How a collision ended. Energies are shares of what the collision had to spend, ½ μ v² with μ = m M_e/(m + M_e) and v
/// the closing speed at the point of impact; what the two shares leave is relative motion of ball and rigid bat.
struct BatRebound {
  double exit_speed_mps = 0;   // of the ball, back where it came from, after its last contact
  double contact_s = 0;        // from the first touch to the last one's end
  std::size_t contacts = 1;    // how often the ball touched
  double largest_m = 0;        // compression of the ball
  double ball_share = 0;       // lost in the ball
  Eigen::VectorXd mode_share;  // that each elastic mode keeps. shape [modes]
};

struct BatCollisionOptions {
  std::size_t steps = 200;           // while the ball goes into a wall: about a fifth of all
  double recontact_window_s = 0.03;  // for a further touch after the last
};

/// The ball against the first `modes` elastic modes of the bat at z_m from the knob; none of them: the rigid bat. Modes
/// are undamped and move exactly under a force that is linear in each step; the force at its end is solved for, so that
/// no mode is too fast for the step. Second order in the step, extrapolated from the step and its double.
/// modes, z_m  as far as there are any: 0 … bat.freq_Hz.size(), 0 … bat.length_m. A bat that runs away from the ball
/// is not touched: 0 contacts, and the ball goes on. errors  InputError: constants too far apart for numbers.
BatRebound bat_rebound(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                       const BatCollisionOptions& options = {});

/// bat_rebound at each of z_m, `threads` as in parallel_for.
std::vector<BatRebound> bat_sweep(const BatModes& bat, std::size_t modes, const BatCollision& collision,
                                  const std::vector<double>& z_m, std::size_t threads = 0);

/// The same ball and bat for rigid.hpp: bat_rebound without modes gives exit_speed_mps of this, z from the centre of
/// mass, as a spring that gives e₀² of the energy back is one that gives e₀ of the speed.
RigidCollision rigid_collision(const BatInertia& bat, const BatCollision& collision);

/// Deflection of the bat by the impact at z_m, along the ball's motion and beside the bat's own: rows as the beam's
/// nodes (start of each element, then the bat's end), columns as `time_s` from the touch on, ascending.
Eigen::MatrixXd bat_wave(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                         const std::vector<double>& time_s, const BatCollisionOptions& options = {});

}  // namespace percuss::model
