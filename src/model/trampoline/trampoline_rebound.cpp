#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "core/units.hpp"
#include "model/trampoline/damped_oscillator.hpp"
#include "model/trampoline/trampoline_contact.hpp"

namespace percuss::model {
namespace {

constexpr double kIntervalsPerPeriod = 40;  // each is searched for the next touch
constexpr int kMaxIntervals = 100'000;
constexpr std::size_t kMaxContacts = 1000;

TrampolineForces forces_at(const Trampoline& model, double hoop_Hz) {
  const double omega = kTwoPi * hoop_Hz;
  return {.model = model,
          .barrel_stiffness_Npm = omega * omega * model.barrel_mass_kg,  // (3)
          .inverse_mass_per_kg = 1 / (model.barrel_mass_kg + model.extra_mass_kg)};
}

// Ball and barrel after a separation; both move in closed form.
class FreeFlight {
 public:
  FreeFlight(const TrampolineForces& forces, const BallAndBarrel& start)
      : forces_(forces),
        start_(start),
        barrel_{.omega_radps = std::sqrt(forces.barrel_stiffness_Npm * forces.inverse_mass_per_kg),
                .decay_radps = forces.model.barrel_damping_Nspm * forces.inverse_mass_per_kg / 2} {}

  /// The next touch, or none when the barrel cannot reach the ball.
  std::optional<BallAndBarrel> next_touch() const {
    const double interval_s = kTwoPi / barrel_.omega_radps / kIntervalsPerPeriod;
    const double amplitude_bound_m = barrel_.amplitude_bound_m({.x_m = start_.barrel_m, .v_mps = start_.barrel_mps});
    for (int i = 1; i < kMaxIntervals; ++i) {
      check_budget();
      const double time_s = i * interval_s;
      if (contact_margin(time_s) > 0) {
        const auto crossing = [&](double t) { return contact_margin(t); };
        return after(bracketed_root(crossing, time_s - interval_s, time_s));
      }
      if (start_.ball_mps < 0 && start_.ball_m + time_s * start_.ball_mps < -amplitude_bound_m) break;
    }
    return {};
  }

 private:
  BallAndBarrel after(double time_s) const {
    const auto barrel = barrel_.after({.x_m = start_.barrel_m, .v_mps = start_.barrel_mps}, time_s);
    return {.ball_m = start_.ball_m + time_s * start_.ball_mps,
            .ball_mps = start_.ball_mps,
            .barrel_m = barrel.x_m,
            .barrel_mps = barrel.v_mps,
            .time_s = start_.time_s + time_s};
  }

  // Above zero where ball and barrel overlap and the force is positive. It is continuous: a change of sign is a root.
  double contact_margin(double time_s) const {
    const BallAndBarrel then = after(time_s);
    const double overlap_m = then.overlap_m();
    return std::min(forces_.model.stiffness * overlap_m, forces_.contact_event(overlap_m, then.closing_mps()));
  }

  const TrampolineForces& forces_;
  BallAndBarrel start_;
  DampedOscillator barrel_;
};

}  // namespace

Rebound rebound(const Trampoline& model, double hoop_Hz) {
  const TrampolineForces forces = forces_at(model, hoop_Hz);
  ContactSolver solver(forces);
  const double speed = model.ball_speed_mps;
  BallAndBarrel now = solver.follow({.ball_mps = speed});
  Rebound result{.first_cor = -now.ball_mps / speed};
  while (const auto touch = FreeFlight(forces, now).next_touch()) {
    if (result.contacts == kMaxContacts) {
      throw InputError(fmt::format("the ball has not left the barrel after {} contacts", kMaxContacts),
                       "trampoline model", "give a lighter ball, or a ball or barrel with more damping");
    }
    now = solver.follow(*touch);
    ++result.contacts;
  }
  result.cor = -now.ball_mps / speed;
  result.contact_s = now.time_s;
  if (!std::isfinite(result.cor)) {
    throw InputError("the contact has no finite solution", "trampoline model",
                     "check the constants of ball and barrel");
  }
  return result;
}

Rebound rigid_wall_rebound(const Trampoline& model) {
  const BallAndBarrel end =
      ContactSolver({.model = model, .inverse_mass_per_kg = 0}).follow({.ball_mps = model.ball_speed_mps});
  const double cor = -end.ball_mps / model.ball_speed_mps;
  return {.cor = cor, .first_cor = cor, .contact_s = end.time_s};
}

}  // namespace percuss::model
