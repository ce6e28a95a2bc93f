#pragma once
#include <memory>

#include "model/trampoline/trampoline.hpp"

namespace percuss::model {

/// The state of ball and barrel at one time; positions and speeds are positive towards the barrel.
struct BallAndBarrel {
  double ball_m = 0, ball_mps = 0, barrel_m = 0, barrel_mps = 0;
  double time_s = 0;

  double overlap_m() const { return ball_m - barrel_m; }
  double closing_mps() const { return ball_mps - barrel_mps; }
};

/// The forces of equations (1) and (2) of trampoline.hpp at one hoop frequency.
struct TrampolineForces {
  Trampoline model;
  double barrel_stiffness_Npm = 0;  // (3)
  double inverse_mass_per_kg = 1;   // 1/(m₂ + Δm) of the barrel; 0: a rigid wall

  double contact_N(double overlap_m, double closing_mps) const;  // (2), also where it is negative
  /// The contact force divided by |δ|ᵇ, in N/m^b: it has the same sign, and a simple root at the end of the contact.
  double contact_event(double overlap_m, double closing_mps) const;
  double contact_event_rate(double overlap_m, double closing_mps,
                            double acceleration_mps2) const;  // its time derivative
};

/// Integrates a contact from its start to its end with an eighth-order Runge–Kutta method. It steps in s, where
///   t = t₀ + τ s⁴    (1)
/// The force starts like (t − t₀)ᵇ, that is like s⁴ᵇ. For the default b = 0.52, it has no derivative with respect to t
/// at t₀, but two with respect to s. The end of the contact is found by repeating the last step with other lengths.
class ContactSolver {
 public:
  explicit ContactSolver(const TrampolineForces& forces);
  ~ContactSolver();
  ContactSolver(const ContactSolver&) = delete;
  ContactSolver& operator=(const ContactSolver&) = delete;

  /// Integrates from a touch until the force is zero.
  /// errors  InputError after a million steps.
  BallAndBarrel follow(const BallAndBarrel& start);

 private:
  class Stepper;
  TrampolineForces forces_;
  std::unique_ptr<Stepper> stepper_;
};

}  // namespace percuss::model
