#pragma once
#include "model/impact/ball_on_beam.hpp"

namespace percuss::model {

/// The largest approach of the ball and a rigid wall: α_m of hertz_contact_s.
double hertz_approach_m(const Impact& impact);

/// One contact of ball and beam, integrated once with one nominal step.
class ContactPass {
 public:
  /// `start` is the state at the touch: the ball approaches and does not press yet.
  ContactPass(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s, BallOnBeamState start);

  /// Integrates until the separation. Times of the result count from the touch.
  /// errors  InputError when ball and beam do not separate within the limit of steps
  ImpactResult run(bool series);

  const BallOnBeamState& end() const { return state_; }

 private:
  // The force is not smooth where contact begins and ends: steps shrink with the root of the approach. first_m_ keeps
  // the first step above zero.
  double next_step_s() const;
  // Moves from the saved state by dt_s. Returns BallOnBeamReading::contact_event_m of the new state.
  double move_to(double dt_s);
  // Updates the largest force and deflection, which may lie within the step, and advances the time by dt_s.
  void finish_step(const BallOnBeamReading& before, double dt_s);
  void append_moment(bool wanted);

  BallOnBeam& system_;
  ImpactMethod method_;
  double step_s_, speed_mps_, scale_m_, first_m_ = 0, time_s_ = 0;
  BallOnBeamState state_, saved_;
  BallOnBeamReading now_;
  double back_m_ = 0, back_time_s_ = 0;  // largest deflection against the ball's motion
  ImpactResult result_;
};

}  // namespace percuss::model
