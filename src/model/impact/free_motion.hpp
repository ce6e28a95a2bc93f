#pragma once
#include <optional>

#include "model/impact/ball_on_beam.hpp"

namespace percuss::model {

/// The motion of ball and beam after their separation, in closed form. Times count from the separation.
class FreeMotion {
 public:
  FreeMotion(const BallOnBeam& system, const BallOnBeamState& separated);

  struct Point {
    double value = 0, rate = 0;
  };
  Point beam_at(double time_s) const;
  double ball_mps() const { return ball_mps_; }
  double ball_at(double time_s) const { return ball_m_ + ball_mps_ * time_s; }

  /// Whether ball and beam move apart at the separation.
  bool opens() const { return gap_at(0).rate > 0; }
  /// Whether a rigid-body mode carries the struck point away, so that its deflection has no maximum.
  bool flies_off() const { return steady_mps_ != 0; }

  /// The time at which the gap closes again, within `until_s`. The gap, its rate and a bound of the acceleration (from
  /// the modes' amplitudes) give an interval in which the gap stays open. Each step is that interval, so no step
  /// can miss a touch.
  std::optional<double> next_contact_s(double until_s) const;

  struct Peak {
    double value_m = 0, time_s = 0;
  };
  /// The beam's largest deflection in a direction (1: along the ball's motion, −1: against it) within `until_s`, if it
  /// exceeds `floor_m`. The value is the magnitude.
  std::optional<Peak> peak(double until_s, double floor_m, double direction = 1) const;

 private:
  Point gap_at(double time_s) const;

  std::vector<double> omega_, cosine_, sine_;  // of each mode's contribution to the deflection
  double ball_m_, ball_mps_;
  double steady_mps_ = 0;  // of modes of frequency 0
  double bound_mps2_ = 0;  // of the acceleration of the deflection
  double fastest_radps_ = 0;
};

}  // namespace percuss::model
