#include "model/trampoline/trampoline_contact.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/math/roots.hpp"

namespace percuss::model {
namespace {

constexpr std::size_t kContactStates = 4;
constexpr double kScale_s = 1e-3;                     // τ of t = t₀ + τ s⁴: about the duration of a contact
constexpr double kContactTolerance = 1e-10;           // error of a step, relative to the ball's speed
constexpr double kFirstStep = 0.05, kMinStep = 1e-9;  // of s
constexpr double kRootMargin = 1e-12;                 // relative to s: above the rounding error of the separation
constexpr double kStarted = 0.1;  // of s: from here on every contact has force, even if it began without
constexpr double kMaxContactSteps = 1e6;
using ContactState = std::array<double, kContactStates>;  // ball, its speed, barrel, its speed

// Equations (1) and (2) of trampoline.hpp as derivatives with respect to s.
int contact_rates(double s, const double* y, double* dy, void* forces) {
  const auto& f = *static_cast<const TrampolineForces*>(forces);
  const double dt_ds = 4 * kScale_s * s * s * s;
  const double force_N = f.contact_N(y[0] - y[2], y[1] - y[3]);
  dy[0] = dt_ds * y[1];
  dy[1] = -dt_ds * force_N / f.model.ball_mass_kg;
  dy[2] = dt_ds * y[3];
  dy[3] =
      dt_ds * f.inverse_mass_per_kg * (force_N - f.barrel_stiffness_Npm * y[2] - f.model.barrel_damping_Nspm * y[3]);
  return GSL_SUCCESS;
}

}  // namespace

double TrampolineForces::contact_N(double overlap_m, double closing_mps) const {
  if (overlap_m == 0) return 0;
  const double log = std::log(std::abs(overlap_m));  // once for both powers: they take most of the time
  return model.stiffness * overlap_m * std::exp(model.stiffness_exponent * log) +
         model.damping * closing_mps * std::exp(model.damping_exponent * log);
}

double TrampolineForces::contact_event(double overlap_m, double closing_mps) const {
  const double power = 1 + model.stiffness_exponent - model.damping_exponent;
  return model.stiffness * std::copysign(std::pow(std::abs(overlap_m), power), overlap_m) + model.damping * closing_mps;
}

double TrampolineForces::contact_event_rate(double overlap_m, double closing_mps, double acceleration_mps2) const {
  const double power = 1 + model.stiffness_exponent - model.damping_exponent;
  return model.stiffness * power * std::pow(std::abs(overlap_m), power - 1) * closing_mps +
         model.damping * acceleration_mps2;
}

class ContactSolver::Stepper {
 public:
  explicit Stepper(TrampolineForces& forces)
      : forces_(forces),
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, kContactStates), gsl_odeiv2_step_free),
        system_{.function = contact_rates, .jacobian = nullptr, .dimension = kContactStates, .params = &forces} {}

  struct Moment {
    double s = 0;
    ContactState y{}, dy{};  // dy: derivatives with respect to s
  };

  Moment at(double s, const ContactState& y) {
    Moment moment{.s = s, .y = y};
    contact_rates(s, moment.y.data(), moment.dy.data(), &forces_);
    return moment;
  }

  // Takes one step of length h and returns its error in units of the tolerance.
  double take(const Moment& from, double h, Moment& to) {
    ContactState error{};
    to = from;
    to.s = from.s + h;
    gsl_odeiv2_step_apply(step_.get(), from.s, h, to.y.data(), error.data(), from.dy.data(), to.dy.data(), &system_);
    const double speed = kContactTolerance * forces_.model.ball_speed_mps;
    double worst = 0;
    for (std::size_t i = 0; i < kContactStates; ++i) {
      const double size = std::abs(error.at(i)) / (i % 2 == 0 ? speed * kScale_s : speed);
      worst = size <= worst ? worst : size;  // NaN counts as the largest error
    }
    return worst;
  }

  double contact_event(const Moment& m) const { return forces_.contact_event(m.y[0] - m.y[2], m.y[1] - m.y[3]); }

  // Whether the contact event may fall below zero between two moments at which it is positive. Tests the minimum of the
  // cubic through both.
  bool may_separate(const Moment& a, const Moment& b) const {
    const double h = b.s - a.s, ga = contact_event(a), gb = contact_event(b), ra = h * contact_event_rate(a),
                 rb = h * contact_event_rate(b);
    if (!(ra < 0 && rb > 0)) return false;
    const double c = 3 * (gb - ga) - 2 * ra - rb, d = 2 * (ga - gb) + ra + rb;
    const double root = std::sqrt(std::max(0.0, c * c - 3 * d * ra));
    const double at = -ra / (c + root);  // the minimum of the cubic
    return at > 0 && at < 1 && ga + at * (ra + at * (c + at * d)) < 0;
  }

  // Repeats the last step with the length at which the contact event is zero. The step ends just beyond this root.
  // Just before it, rounding could look like another touch.
  Moment separation_state(const Moment& from, const Moment& past) {
    Moment to = past;
    const auto event_after = [&](double h) {
      if (h == 0) return contact_event(from);
      take(from, h, to);
      return contact_event(to);
    };
    take(from, bracketed_root(event_after, 0, past.s - from.s) + kRootMargin * past.s, to);
    return to;
  }

 private:
  double contact_event_rate(const Moment& m) const {
    const double dt_ds = 4 * kScale_s * m.s * m.s * m.s;
    if (dt_ds == 0) return 0;
    return dt_ds * forces_.contact_event_rate(m.y[0] - m.y[2], m.y[1] - m.y[3], (m.dy[1] - m.dy[3]) / dt_ds);
  }

  TrampolineForces& forces_;
  std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step_;
  gsl_odeiv2_system system_;
};

ContactSolver::ContactSolver(const TrampolineForces& forces)
    : forces_(forces), stepper_(std::make_unique<Stepper>(forces_)) {}

ContactSolver::~ContactSolver() = default;

BallAndBarrel ContactSolver::follow(const BallAndBarrel& start) {
  auto now = stepper_->at(0, {start.ball_m, start.ball_mps, start.barrel_m, start.barrel_mps});
  auto next = now;
  double h = kFirstStep, steps = 0;
  for (bool holds = true; holds;) {
    check_budget();
    if (++steps > kMaxContactSteps)
      throw InputError("the contact does not end", "trampoline model",
                       "use a higher hoop frequency, or check the constants of the ball", {"hoop"});
    const double error = stepper_->take(now, h, next);
    if (!(error <= 1) && h > kMinStep) {
      h *= std::isfinite(error) ? std::clamp(0.9 * std::pow(error, -0.125), 0.1, 0.9) : 0.1;
      continue;
    }
    // At a touch the contact event is zero to within rounding. Only a contact that has had force can end.
    const bool settling = stepper_->contact_event(now) <= 0 && now.s < kStarted;
    holds = stepper_->contact_event(next) >= 0 || settling;
    if (holds && !settling && stepper_->may_separate(now, next) && h > kMinStep) {
      h /= 2;
      continue;
    }
    if (!holds) next = stepper_->separation_state(now, next);
    now = next;
    h *= std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.125), 0.5, 4.0);
  }
  return {.ball_m = now.y[0],
          .ball_mps = now.y[1],
          .barrel_m = now.y[2],
          .barrel_mps = now.y[3],
          .time_s = start.time_s + kScale_s * std::pow(now.s, 4)};
}

}  // namespace percuss::model
