#pragma once
#include <Eigen/Core>
#include <vector>

#include "model/bat/bat_modes.hpp"
#include "model/bat/rigid_collision.hpp"

namespace percuss::model {

/// A ball as a spring with loss. Loading and unloading follow different curves:
///   F = k₁ u^α where u is the largest compression so far, else F = k₂ u^β,                             (1)
///   β = (1 + α)/e₀² − 1, k₂ such that F is continuous at the largest u                                 (2)
/// The ball returns e₀² of the energy at any speed. After it leaves the bat it has its original shape.
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
  double bat_speed_mps = 0;      // of its centre of mass, towards the ball; a free bat only
  double swing_rate_radps = 60;  // about its centre of mass, or about its pin; the barrel moves towards the ball
};

/// The speed of the bat at z_m before the impact, towards the ball. A bat on a spring or in a clamp is at rest.
double struck_speed_mps(const BatModes& bat, const BatCollision& collision, double z_m);

/// The exit speed from the rigid bat, with u from struck_speed_mps and 1/M_e from rigid_accelerance_per_kg:
///   v' = [v (e − m/M_e) + u (1 + e)]/(1 + m/M_e)                                                        (3)
/// It equals exit_speed_mps of rigid_collision.hpp for a free bat. Where the bat moves away from the ball, the ball
/// keeps its speed. On a spring the rigid bat turns about the spring's pin, and the spring does not act during the
/// contact.
double rigid_exit_speed_mps(const BatModes& bat, const BatCollision& collision, double z_m);

/// The result of a collision. Energies are shares of the collision energy ½ μ v², with μ = m M_e/(m + M_e) and v the
/// closing speed at the point of impact. The remaining share is the energy of the relative motion of ball and
/// rigid bat after the impact.
struct BatRebound {
  double exit_speed_mps = 0;   // of the ball after its last contact, against its initial direction
  double contact_s = 0;        // from the first touch to the end of the last contact
  std::size_t contacts = 1;    // number of contacts
  double largest_m = 0;        // largest compression of the ball
  double ball_share = 0;       // lost in the ball
  Eigen::VectorXd mode_share;  // in each elastic mode. shape [modes]
};

struct BatCollisionOptions {
  std::size_t steps = 200;           // in the time (largest compression on a rigid wall)/(closing speed)
  double recontact_window_s = 0.03;  // search for a further contact after the last
};

/// Simulates the ball against the first `modes` elastic modes of the bat at z_m from the knob. With no modes the bat is
/// rigid. The modes are undamped and move exactly under a force that is linear in each step. The force at the end of a
/// step is solved for (implicit), so the step is stable for every mode. The method has second order in the step.
/// Exit speed and energy shares are extrapolated from two step lengths, one twice the other, if both give the same
/// number of contacts.
/// A bat that moves away from the ball is not touched: 0 contacts, and the ball keeps its speed.
/// domain  modes 0 … bat.freq_Hz.size(), z_m 0 … bat.length_m
/// errors  InputError where the constants leave no finite result.
BatRebound bat_rebound(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                       const BatCollisionOptions& options = {});

/// Computes bat_rebound at each of z_m, `threads` as in parallel_for.
std::vector<BatRebound> bat_sweep(const BatModes& bat, std::size_t modes, const BatCollision& collision,
                                  const std::vector<double>& z_m, std::size_t threads = 0);

/// Converts ball and bat for rigid_collision.hpp. bat_rebound without modes equals exit_speed_mps of the result, with z
/// from the centre of mass: a spring that returns e₀² of the energy returns e₀ of the speed.
RigidCollision rigid_collision(const BatInertia& bat, const BatCollision& collision);

/// Computes the deflection of the bat due to an impact at z_m: positive along the ball's motion, without the bat's own
/// motion before the impact.
/// shapes  rows as the element nodes (start of each element, then the end of the bat), columns as `time_s`, which
/// ascends from the touch on
Eigen::MatrixXd bat_wave(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
                         const std::vector<double>& time_s, const BatCollisionOptions& options = {});

}  // namespace percuss::model
