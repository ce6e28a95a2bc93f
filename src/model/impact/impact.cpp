#include "model/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "core/budget.hpp"
#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "model/impact/ball_on_beam.hpp"
#include "model/impact/free_motion.hpp"

namespace percuss::model {
namespace {

constexpr double kFirstPassSteps = 32;            // of the first pass, per Hertz contact time
constexpr double kMaxImpactError = 5e-10;         // of the coefficient of restitution, and of the energy
constexpr double kTargetImpactError = 2e-10;      // from which the next shorter step is chosen
constexpr std::size_t kMaxModeSteps = 5'000'000;  // modes times steps in one pass: less than a second
constexpr std::size_t kStepsPerCheck = 64;        // of the budget: below 1 ms
constexpr double kClassicStep_s = 1e-5;
constexpr std::size_t kSeriesContact = 400, kSeriesFree = 4000;

double hertz_approach_m(const Impact& impact) {
  return std::pow(1.25 * impact.ball_mass_kg * impact.speed_mps * impact.speed_mps / impact.hertz_Npm15, 0.4);
}

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

// Integrates the contact once, with one nominal step.
class ContactPass {
 public:
  ContactPass(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s)
      : system_(system), method_(method), step_s_(step_s), scale_m_(hertz_approach_m(impact)) {
    state_ = system.start(impact.speed_mps);
    now_ = system.read(state_);
    first_m_ = std::pow(step_s * impact.speed_mps, 2) / scale_m_;
  }

  ImpactResult run(bool series) {
    const double energy_J = now_.energy_J, speed_mps = state_.ball_mps;
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
      update_peaks(before, dt_s);
      result_.energy_error = std::max(result_.energy_error, std::abs(now_.energy_J / energy_J - 1));
    }
    result_.contact_s = time_s_;
    result_.cor = -state_.ball_mps / speed_mps;
    result_.lost_J = state_.lost_J;
    const bool back = back_m_ > result_.forward_deflection_m;
    result_.peak_deflection_m = back ? -back_m_ : result_.forward_deflection_m;
    result_.peak_deflection_time_s = back ? back_time_s_ : result_.forward_deflection_time_s;
    return std::move(result_);
  }

  const BallOnBeamState& end() const { return state_; }

 private:
  // The force is not smooth where contact begins and ends: steps shrink with the root of the approach. first_m_ keeps
  // the first step above zero.
  double next_step_s() const {
    if (method_ == ImpactMethod::small_increment) return step_s_;
    return step_s_ * std::min(1.0, std::sqrt((std::max(0.0, now_.approach_m) + first_m_) / scale_m_));
  }
  // Moves from the saved state by dt_s and returns the contact event there.
  double move_to(double dt_s) {
    state_ = saved_;
    if (method_ == ImpactMethod::small_increment) {
      system_.small_increment(state_, dt_s);
    } else {
      system_.step(state_, dt_s);
    }
    now_ = system_.read(state_);
    return now_.contact_event_m;
  }
  // Updates the largest force and deflection, which may lie within the step.
  void update_peaks(const BallOnBeamReading& before, double dt_s) {
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
  void append_moment(bool wanted) {
    if (!wanted) return;
    result_.series.push_back({.time_s = time_s_,
                              .beam_m = now_.beam_m,
                              .ball_m = state_.ball_m,
                              .force_N = now_.force_N,
                              .ball_speed_mps = state_.ball_mps});
  }

  BallOnBeam& system_;
  ImpactMethod method_;
  double step_s_, scale_m_, first_m_ = 0, time_s_ = 0;
  BallOnBeamState state_, saved_;
  BallOnBeamReading now_;
  double back_m_ = 0, back_time_s_ = 0;  // largest deflection against the ball's motion
  ImpactResult result_;
};

[[noreturn]] void refuse_values(const char* what) {
  throw InputError(std::string(what) + " beyond the range of numbers", "ball and beam",
                   "check the values of ball and beam", {"ball_mass", "speed", "hertz", "ei", "rho_a"});
}

double worst_impact_error(const ImpactResult& result) {
  return std::max(result.cor_uncertainty.value_or(1), result.energy_error);
}

bool has_converged(const ImpactResult& result) { return worst_impact_error(result) <= kMaxImpactError; }

void thin_series(std::vector<ImpactMoment>& series) {
  const std::size_t every = std::max<std::size_t>(1, series.size() / kSeriesContact);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (i % every == 0 || i + 1 == series.size()) series[kept++] = series[i];
  }
  series.resize(kept);
}

void follow_free_motion(const FreeMotion& free, ImpactResult& result, bool series) {
  if (const auto touch = free.next_contact_s(kFollowUp_s)) result.recontact_s = result.contact_s + *touch;
  for (const double direction : {1.0, -1.0}) {
    const auto peak = free.peak(kFollowUp_s, direction > 0 ? result.forward_deflection_m : 0, direction);
    if (!peak) continue;
    const double time_s = result.contact_s + peak->time_s;
    if (direction > 0)
      std::tie(result.forward_deflection_m, result.forward_deflection_time_s) = std::pair(peak->value_m, time_s);
    if (peak->value_m > std::abs(result.peak_deflection_m))
      std::tie(result.peak_deflection_m, result.peak_deflection_time_s) = std::pair(direction * peak->value_m, time_s);
  }
  if (!series) return;
  thin_series(result.series);
  result.series.back().force_N = 0;  // the computed force differs from zero only by rounding
  for (std::size_t i = 1; i <= kSeriesFree; ++i) {
    const double time_s = kFollowUp_s * static_cast<double>(i) / static_cast<double>(kSeriesFree);
    result.series.push_back({.time_s = result.contact_s + time_s,
                             .beam_m = free.beam_at(time_s).value,
                             .ball_m = free.ball_at(time_s),
                             .ball_speed_mps = free.ball_mps()});
  }
}

}  // namespace

double hertz_contact_s(const Impact& impact) { return 2.943275 * hertz_approach_m(impact) / impact.speed_mps; }

double hysteresis_for_spm(double restitution, double speed_mps) {
  if (restitution >= 1) return 0;
  const double e = restitution;
  const auto difference = [&](double d) { return std::log1p(d) - std::log1p(-e * d) - d * (1 + e); };  // (3)
  // For small d the difference is −d² (1 − e²)/2, below zero; towards 1/e it grows without bound.
  const double low = 0.75 * (1 - e * e) / (1 + e * e * e);
  const double high = (1 - 1e-15) / e;
  if (difference(high) < 0) return high / speed_mps;  // the root lies within a relative 1e-15 of 1/e
  return bracketed_root(difference, low, high) / speed_mps;
}

ImpactResult simulate_impact(const Impact& impact, const ImpactOptions& options) {
  if (!std::isnormal(hertz_approach_m(impact)) || !std::isnormal(hertz_contact_s(impact)))
    refuse_values("the ball's approach and the contact's duration are");
  BallOnBeam system(impact);
  const bool controlled = options.method == ImpactMethod::modal && options.step_s == 0;
  double step_s = options.step_s;
  if (step_s == 0) step_s = controlled ? hertz_contact_s(impact) / kFirstPassSteps : kClassicStep_s;
  ContactPass first(system, impact, options.method, step_s);
  ImpactResult result = first.run(options.series);
  BallOnBeamState end = first.end();
  for (double shorter = 2; controlled && !has_converged(result);) {
    step_s /= shorter;
    ContactPass finer(system, impact, options.method, step_s);
    const double before = result.cor;
    result = finer.run(options.series);
    end = finer.end();
    if (!std::isfinite(result.cor + result.energy_error)) refuse_values("the motion is");
    result.cor_uncertainty = std::abs(result.cor - before) / (std::pow(shorter, 4) - 1);
    shorter = std::clamp(std::pow(worst_impact_error(result) / kTargetImpactError, 0.25), 1.5, 16.0);
  }
  result.omega_radps = system.omega_radps();
  follow_free_motion(FreeMotion(system, end), result, options.series);
  return result;
}

}  // namespace percuss::model
