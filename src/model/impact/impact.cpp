#include "model/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "model/impact/ball_on_beam.hpp"
#include "model/impact/free_motion.hpp"

namespace percuss::model {
namespace {

constexpr double kFirstPassSteps = 32;            // to the Hertz time
constexpr double kSettledImpact = 5e-10;          // error of the coefficient of restitution, and of the energy
constexpr double kAimedImpact = 2e-10;            // … at which a shorter step is aimed
constexpr std::size_t kMaxModeSteps = 5'000'000;  // in one pass: less than a second
constexpr double kClassicStep_s = 1e-5;
constexpr std::size_t kSeriesContact = 400, kSeriesFree = 4000;

double hertz_approach_m(const Impact& impact) {
  return std::pow(1.25 * impact.ball_mass_kg * impact.speed_mps * impact.speed_mps / impact.hertz_Npm15, 0.4);
}

// The largest value of the cubic through two points with these rates, and where (0 to 1).
struct CubicTop {
  double value = 0, at = 0;
};
CubicTop top_of_cubic(double from, double from_rate, double to, double to_rate, double width) {
  const auto cubic = [&](double t) {
    const double u = 1 - t;
    return u * u * ((1 + 2 * t) * from + t * width * from_rate) + t * t * ((3 - 2 * t) * to - u * width * to_rate);
  };
  CubicTop top{.value = std::max(from, to), .at = to > from ? 1.0 : 0.0};
  if (!(from_rate > 0 && to_rate < 0)) return top;
  const double chord = (to - from) / width;
  const auto rate = [&](double t) {
    const double u = 1 - t;
    return u * u * from_rate + t * t * to_rate + 2 * t * u * (3 * chord - from_rate - to_rate);
  };
  const double at = bracketed_root(rate, 0, 1);
  return cubic(at) > top.value ? CubicTop{.value = cubic(at), .at = at} : top;
}

// One pass through the contact with steps of one nominal length.
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
    remember(series);
    for (bool touching = true; touching; remember(series)) {
      if (++result_.steps * system_.modes() > kMaxModeSteps) {
        throw InputError("ball and beam do not separate", "the contact, after as many steps as are reasonable",
                         "look for a value far off (--hertz, --ball-mass, --speed, --ei, --rho-a), or take a longer "
                         "--step or fewer --modes");
      }
      const BallOnBeamReading before = now_;
      double dt_s = next_step_s();
      kept_ = state_;
      move_to(dt_s);
      touching = now_.contact_event_m > 0;
      if (!touching) {
        const double inside_m = std::max(before.contact_event_m, std::numeric_limits<double>::min());
        dt_s = bracketed_root([&](double t) { return t == 0 ? inside_m : move_to(t); }, 0, dt_s);
        move_to(dt_s);
      }
      watch(before, dt_s);
      result_.energy_error = std::max(result_.energy_error, std::abs(now_.energy_J / energy_J - 1));
    }
    result_.contact_s = time_s_;
    result_.cor = -state_.ball_mps / speed_mps;
    result_.lost_J = state_.lost_J;
    return std::move(result_);
  }

  const BallOnBeamState& end() const { return state_; }

 private:
  double next_step_s() const {
    if (method_ == ImpactMethod::small_increment) return step_s_;
    return step_s_ * std::min(1.0, std::sqrt((std::max(0.0, now_.approach_m) + first_m_) / scale_m_));
  }
  // From the kept state; returns the grip there.
  double move_to(double dt_s) {
    state_ = kept_;
    if (method_ == ImpactMethod::small_increment) {
      system_.small_increment(state_, dt_s);
    } else {
      system_.step(state_, dt_s);
    }
    now_ = system_.read(state_);
    return now_.contact_event_m;
  }
  // Force and deflection may be largest within the step.
  void watch(const BallOnBeamReading& before, double dt_s) {
    const CubicTop force = top_of_cubic(before.force_N, before.force_rate_Nps, now_.force_N, now_.force_rate_Nps, dt_s);
    result_.peak_force_N = std::max(result_.peak_force_N, force.value);
    const CubicTop bent = top_of_cubic(before.beam_m, before.beam_mps, now_.beam_m, now_.beam_mps, dt_s);
    if (bent.value > result_.peak_deflection_m) {
      result_.peak_deflection_m = bent.value;
      result_.peak_deflection_time_s = time_s_ + bent.at * dt_s;
    }
    time_s_ += dt_s;
  }
  void remember(bool wanted) {
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
  BallOnBeamState state_, kept_;
  BallOnBeamReading now_;
  ImpactResult result_;
};

[[noreturn]] void refuse_values(const char* what) {
  throw InputError(std::string(what) + " beyond what numbers hold", "ball and beam",
                   "look at --ball-mass, --speed, --hertz, --ei and --rho-a");
}

double worst_impact_error(const ImpactResult& result) {
  return std::max(result.cor_uncertainty.value_or(1), result.energy_error);
}

bool settled_impact(const ImpactResult& result) { return worst_impact_error(result) <= kSettledImpact; }

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
  if (const auto peak = free.peak(kFollowUp_s, result.peak_deflection_m)) {
    result.peak_deflection_m = peak->value_m;
    result.peak_deflection_time_s = result.contact_s + peak->time_s;
  }
  if (!series) return;
  thin_series(result.series);
  result.series.back().force_N = 0;  // what rounding leaves of it
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
  // Below zero for small d, where the terms cancel up to −d² (1 − e²)/2; without bound towards 1/e.
  const double low = 0.75 * (1 - e * e) / (1 + e * e * e);
  return bracketed_root(difference, low, (1 - 1e-15) / e) / speed_mps;
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
  for (double shorter = 2; controlled && !settled_impact(result);) {
    step_s /= shorter;
    ContactPass finer(system, impact, options.method, step_s);
    const double before = result.cor;
    result = finer.run(options.series);
    end = finer.end();
    if (!std::isfinite(result.cor + result.energy_error)) refuse_values("the motion is");
    result.cor_uncertainty = std::abs(result.cor - before) / (std::pow(shorter, 4) - 1);
    shorter = std::clamp(std::pow(worst_impact_error(result) / kAimedImpact, 0.25), 1.5, 16.0);
  }
  result.omega_radps = system.omega_radps();
  follow_free_motion(FreeMotion(system, end), result, options.series);
  return result;
}

}  // namespace percuss::model
