#include "model/impact/contact_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/math/roots.hpp"

namespace percuss::model {
namespace {

constexpr std::size_t kMaxModeSteps = 5'000'000;  // modes times steps in one pass: less than a second
constexpr std::size_t kStepsPerCheck = 64;        // of the budget: below 1 ms

// The maximum of the cubic through two points with these rates, and its position from 0 to 1.
struct CubicMaximum {
  double value = 0, at = 0;
};
CubicMaximum maximum_of_cubic(double from, double from_rate, double to, double to_rate, double width) {
  const auto cubic = [&](double t) {
    const double u = 1 - t;
    return u * u * ((1 + 2 * t) * from + t * width * from_rate) + t * t * ((3 - 2 * t) * to - u * width * to_rate);
  };
  CubicMaximum largest{.value = std::max(from, to), .at = to > from ? 1.0 : 0.0};
  if (!(from_rate > 0 && to_rate < 0)) return largest;
  const double chord = (to - from) / width;
  const auto rate = [&](double t) {
    const double u = 1 - t;
    return u * u * from_rate + t * t * to_rate + 2 * t * u * (3 * chord - from_rate - to_rate);
  };
  const double at = bracketed_root(rate, 0, 1);
  return cubic(at) > largest.value ? CubicMaximum{.value = cubic(at), .at = at} : largest;
}

}  // namespace

double hertz_approach_m(const Impact& impact) {
  return std::pow(1.25 * impact.ball_mass_kg * impact.speed_mps * impact.speed_mps / impact.hertz_Npm15, 0.4);
}

ContactPass::ContactPass(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s,
                         BallOnBeamState start)
    : system_(system),
      method_(method),
      step_s_(step_s),
      speed_mps_(impact.speed_mps),
      scale_m_(hertz_approach_m(impact)),
      state_(std::move(start)) {
  now_ = system.read(state_);
  first_m_ = std::pow(step_s * impact.speed_mps, 2) / scale_m_;
}

ImpactResult ContactPass::run(bool series) {
  const double energy_J = now_.energy_J;
  append_moment(series);
  for (bool touching = true; touching; append_moment(series)) {
    if (++result_.steps * system_.modes() > kMaxModeSteps) {
      throw InputError("ball and beam do not separate", "the contact, at the limit of steps",
                       "check ball and beam for a wrong value, or use a longer step or fewer modes",
                       {"hertz", "ball_mass", "speed", "ei", "rho_a", "step", "modes"});
    }
    if (result_.steps % kStepsPerCheck == 0) check_budget();
    const BallOnBeamReading before = now_;
    double dt_s = next_step_s();
    saved_ = state_;
    move_to(dt_s);
    touching = now_.contact_event_m > 0;
    if (!touching) {
      const double start_event_m = std::max(before.contact_event_m, std::numeric_limits<double>::min());
      dt_s = bracketed_root([&](double t) { return t == 0 ? start_event_m : move_to(t); }, 0, dt_s);
      move_to(dt_s);
    }
    finish_step(before, dt_s);
    result_.energy_error = std::max(result_.energy_error, std::abs(now_.energy_J / energy_J - 1));
  }
  result_.contact_s = time_s_;
  result_.cor = -state_.ball_mps / speed_mps_;
  result_.lost_J = state_.lost_J;
  const bool back = back_m_ > result_.forward_deflection_m;
  result_.peak_deflection_m = back ? -back_m_ : result_.forward_deflection_m;
  result_.peak_deflection_time_s = back ? back_time_s_ : result_.forward_deflection_time_s;
  return std::move(result_);
}

double ContactPass::next_step_s() const {
  if (method_ == ImpactMethod::small_increment) return step_s_;
  return step_s_ * std::min(1.0, std::sqrt((std::max(0.0, now_.approach_m) + first_m_) / scale_m_));
}

double ContactPass::move_to(double dt_s) {
  state_ = saved_;
  if (method_ == ImpactMethod::small_increment) {
    system_.small_increment(state_, dt_s);
  } else {
    system_.step(state_, dt_s);
  }
  now_ = system_.read(state_);
  return now_.contact_event_m;
}

void ContactPass::finish_step(const BallOnBeamReading& before, double dt_s) {
  const CubicMaximum force =
      maximum_of_cubic(before.force_N, before.force_rate_Nps, now_.force_N, now_.force_rate_Nps, dt_s);
  result_.peak_force_N = std::max(result_.peak_force_N, force.value);
  const CubicMaximum bent = maximum_of_cubic(before.beam_m, before.beam_mps, now_.beam_m, now_.beam_mps, dt_s);
  if (bent.value > result_.forward_deflection_m) {
    result_.forward_deflection_m = bent.value;
    result_.forward_deflection_time_s = time_s_ + bent.at * dt_s;
  }
  const CubicMaximum back = maximum_of_cubic(-before.beam_m, -before.beam_mps, -now_.beam_m, -now_.beam_mps, dt_s);
  if (back.value > back_m_) {
    back_m_ = back.value;
    back_time_s_ = time_s_ + back.at * dt_s;
  }
  time_s_ += dt_s;
}

void ContactPass::append_moment(bool wanted) {
  if (!wanted) return;
  result_.series.push_back({.time_s = time_s_,
                            .beam_m = now_.beam_m,
                            .ball_m = state_.ball_m,
                            .force_N = now_.force_N,
                            .ball_speed_mps = state_.ball_mps});
}

}  // namespace percuss::model
