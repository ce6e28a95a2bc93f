#include "model/impact/impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "core/math/roots.hpp"
#include "model/impact/ball_on_beam.hpp"
#include "model/impact/contact_chain.hpp"
#include "model/impact/contact_pass.hpp"
#include "model/impact/free_motion.hpp"

namespace percuss::model {
namespace {

constexpr double kFirstPassSteps = 32;          // of the first pass, per Hertz contact time
constexpr double kMaxImpactError = 5e-10;       // of the coefficient of restitution, and of the energy
constexpr double kTargetImpactError = 2e-10;    // from which the next shorter step is chosen
constexpr double kSmallIncrementStep_s = 1e-5;  // default
// Moments in the series: of a contact of many steps, this many to twice as many; of the free motion.
constexpr std::size_t kSeriesContact = 400, kSeriesFree = 4000;

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

// Extends the largest deflections of the contact to the free motion.
void find_largest_deflection(const FreeMotion& free, ImpactResult& result) {
  if (result.flies_off) {
    result.peak_deflection_m = result.peak_deflection_time_s = std::numeric_limits<double>::quiet_NaN();
    result.forward_deflection_m = result.forward_deflection_time_s = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  for (const double direction : {1.0, -1.0}) {
    const auto peak = free.peak(kFollowUp_s, direction > 0 ? result.forward_deflection_m : 0, direction);
    if (!peak) continue;
    const double time_s = result.contact_s + peak->time_s;
    if (direction > 0) {
      result.forward_deflection_m = peak->value_m;
      result.forward_deflection_time_s = time_s;
    }
    if (peak->value_m > std::abs(result.peak_deflection_m)) {
      result.peak_deflection_m = direction * peak->value_m;
      result.peak_deflection_time_s = time_s;
    }
  }
}

void follow_free_motion(const FreeMotion& free, ImpactResult& result, bool series) {
  if (const auto touch = free.next_contact_s(kFollowUp_s)) result.recontact_s = result.contact_s + *touch;
  result.flies_off = free.flies_off();
  find_largest_deflection(free, result);
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

// With step_s, follows the ball from the first separation to the end of its last contact. Then computes all contacts
// again, the first included, with half the step. The second motion is the result; the difference between the two gives
// the uncertainty.
void follow_contacts(BallOnBeam& system, const Impact& impact, ImpactMethod method, double step_s,
                     const BallOnBeamState& separated, ImpactResult& result) {
  const ContactChain coarse = contact_chain(system, impact, method, step_s, separated, result.contact_s);
  ContactPass first(system, impact, method, step_s / 2, system.start(impact.speed_mps));
  const double contact_s = first.run(false).contact_s;
  const ContactChain fine = contact_chain(system, impact, method, step_s / 2, first.end(), contact_s);
  result.contacts = fine.contacts;
  result.last_separation_s = fine.last_separation_s;
  result.energy_error = std::max(result.energy_error, fine.energy_error);
  if (!fine.complete) return;
  result.final_cor = -fine.ball_mps / impact.speed_mps;
  // Fourth order: halving the step leaves a 15th of the change, if the contacts correspond.
  const double orders = method == ImpactMethod::modal && coarse.contacts == fine.contacts ? 15 : 1;
  result.final_cor_uncertainty = std::abs(fine.ball_mps - coarse.ball_mps) / impact.speed_mps / orders;
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
  if (step_s == 0) step_s = controlled ? hertz_contact_s(impact) / kFirstPassSteps : kSmallIncrementStep_s;
  ContactPass first(system, impact, options.method, step_s, system.start(impact.speed_mps));
  ImpactResult result = first.run(options.series);
  BallOnBeamState end = first.end();
  for (double shorter = 2; controlled && !has_converged(result);) {
    step_s /= shorter;
    ContactPass finer(system, impact, options.method, step_s, system.start(impact.speed_mps));
    const double before = result.cor;
    result = finer.run(options.series);
    end = finer.end();
    if (!std::isfinite(result.cor + result.energy_error)) refuse_values("the motion is");
    result.cor_uncertainty = std::abs(result.cor - before) / (std::pow(shorter, 4) - 1);
    shorter = std::clamp(std::pow(worst_impact_error(result) / kTargetImpactError, 0.25), 1.5, 16.0);
  }
  result.omega_radps = system.omega_radps();
  follow_free_motion(FreeMotion(system, end), result, options.series);
  result.final_cor = result.cor;
  result.final_cor_uncertainty = result.cor_uncertainty;
  result.last_separation_s = result.contact_s;
  if (result.recontact_s) {
    result.final_cor = result.final_cor_uncertainty = std::nullopt;
    follow_contacts(system, impact, options.method, step_s, end, result);
  }
  return result;
}

}  // namespace percuss::model
