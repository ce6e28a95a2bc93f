#pragma once
#include <memory>

#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// Ball and barrel at one moment; x and v positive towards the barrel.
struct BallAndBarrel {
  double ball_m = 0, ball_mps = 0, barrel_m = 0, barrel_mps = 0;
  double time_s = 0;

  double overlap_m() const { return ball_m - barrel_m; }
  double closing_mps() const { return ball_mps - barrel_mps; }
};

/// What of the trampoline's equations (1) and (2) holds at one hoop frequency.
struct TrampolineForces {
  Trampoline model;
  double barrel_stiffness_Npm = 0;  // (3)
  double barrel_compliance = 1;     // 1/(m₂ + Δm); 0: a wall

  double contact_N(double overlap_m, double closing_mps) const;  // (2) without its "where positive"
  /// The contact force over |δ|ᵇ, in N/m^b: of the same sign, but with a simple root where it ends.
  double contact_event(double overlap_m, double closing_mps) const;
  double contact_event_rate(double overlap_m, double closing_mps, double acceleration_mps2) const;  // its rate per s
};

/// Follows contacts from their start to their end with an eighth-order Runge–Kutta method.
///   t = t₀ + τ s⁴    (1)
/// is the time it steps in: the force sets in like tᵇ, which has no derivatives at t₀ but several in s. The end is
/// found by taking the last step again with other lengths.
class ContactSolver {
 public:
  explicit ContactSolver(const TrampolineForces& forces);
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  /// From a touch to the moment when the force has fallen to zero. errors  InputError after a million steps.
  BallAndBarrel follow(const BallAndBarrel& start);

 private:
  class Stepper;
  TrampolineForces forces_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace percuss::model
