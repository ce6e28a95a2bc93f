#pragma once
#include <Eigen/Core>

#include "model/bat/bat_collision.hpp"
#include "model/bat/modal_stepper.hpp"

namespace percuss::model {

/// Amplitudes of the two rigid motions, then of the first `modes` elastic ones. shape [2 + modes].
Eigen::ArrayXd rigid_and_elastic(const Eigen::Vector2d& rigid, const Eigen::VectorXd& elastic, Eigen::Index modes);

/// One collision of a ball with a bat under way, seen by one who moves with the bat as it came. The closing speed is
/// above zero.
class BatImpact {
 public:
  BatImpact(const BatModes& bat, std::size_t modes, const BatCollision& collision, double z_m,
            const BatCollisionOptions& options);

  const ModalState& bat() const { return bat_; }

  // A step with the ball on the bat, or about to be.
  void step();

  // Of the rigid motions and the modes; times must not go back.
  Eigen::VectorXd amplitudes_at(double time_s);

  BatRebound run();

 private:
  // The largest compression between the step's ends, by the cubic with their values and slopes.
  double turning_point(double free_u, double free_rate) const;

  // u + give · F(u) = free_u, whose left side rises: Newton's method within a bracket.
  double end_force(double free_u) const;
  double power_at(double u) const;

  // Whether the bat catches up with the ball; if so, stands just before it does.
  bool will_recontact();

  // The ball goes away from the rigid bat, and no vibration reaches that far.
  bool has_separated() const;

  LossyBall ball_;
  double swing_mps_, closing_mps_, wall_m_;
  Eigen::Index count_;
  Eigen::ArrayXd omega_;
  ModalStepper contact_, free_;
  double compliance_, compliance_rate_;  // what a newton at a step's end takes from the compression and from its rate
  double recontact_window_s_;
  ModalState bat_, earlier_;  // now, and a step ago
  double earlier_N_ = 0;
  double ball_m_ = 0, ball_mps_, force_N_ = 0, time_s_ = 0;
  double u_m_ = 0, rate_mps_, largest_m_ = 0, deepest_m_ = 0;  // of the ball's compression
};

}  // namespace percuss::model
