#pragma once
#include <Eigen/Core>

#include "model/bat/bat_collision.hpp"
#include "model/bat/modal_stepper.hpp"

namespace percuss::model {

/// One value per mode: of the two rigid-body modes, then of the first `modes` elastic modes. shape [2 + modes].
Eigen::ArrayXd rigid_and_elastic(const Eigen::Vector2d& rigid, const Eigen::VectorXd& elastic, Eigen::Index modes);

/// A collision of a ball with a bat, step by step, in the frame of the bat's initial motion.
/// Precondition: the closing speed is above zero.
class BatImpact {
 public:
  BatImpact(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
            const BatCollisionOptions& options);

  const ModalState& bat() const { return bat_; }

  /// Advances by one step during the contact or just before it.
  void step();

  /// Advances to time_s and returns the amplitudes of all modes there. Times must not decrease from call to call.
  Eigen::VectorXd amplitudes_at(double time_s);

  /// Runs the collision to its end, from the first touch.
  BatRebound run();

 private:
  // The largest compression within the step, from the cubic through the values and slopes at its ends.
  double turning_point(double free_u, double free_rate) const;

  // Solves u + compliance · F(u) = free_u for F. The left side rises with u, so Newton's method within a bracket
  // converges. It needs about three evaluations, and bracketed_root needs ten: most of the time of a step goes here.
  double end_force(double free_u) const;
  double exponent_at(double u) const;

  // Whether the bat catches up with the ball. If it does, the state is the one just before the touch.
  bool will_recontact();

  // Whether the ball moves away from the rigid bat and lies beyond the reach of its vibration.
  bool has_separated() const;

  LossyBall ball_;
  double swing_mps_, closing_mps_;  // speed of the bat at the point of impact, and of the ball relative to it
  double wall_m_;                   // largest compression of the ball on a rigid wall at the closing speed
  Eigen::Index count_;
  Eigen::ArrayXd omega_;
  ModalStepper contact_, free_;
  double compliance_, compliance_rate_;  // reduction of the compression and of its rate per newton at a step's end
  double recontact_window_s_;
  ModalState bat_, earlier_;  // now, and one step earlier
  double earlier_N_ = 0;
  double ball_m_ = 0, ball_mps_, force_N_ = 0, time_s_ = 0;
  double u_m_ = 0, rate_mps_, largest_m_ = 0, deepest_m_ = 0;  // of the ball's compression
};

}  // namespace percuss::model
