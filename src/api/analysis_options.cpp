#include <algorithm>
#include <cmath>
#include <utility>

#include "api/handles.hpp"
#include "core/error.hpp"
#include "percuss/analysis.hpp"

namespace percuss::api {
namespace {

constexpr const char* kOptions = "options";

frf::Estimator estimator_of(Estimator estimator) {
  if (estimator == Estimator::h2) return frf::Estimator::h2;
  return estimator == Estimator::hv ? frf::Estimator::hv : frf::Estimator::h1;
}

identify::Effort effort_of(Effort effort) {
  if (effort == Effort::quick) return identify::Effort::quick;
  return effort == Effort::standard ? identify::Effort::standard : identify::Effort::best;
}

void require_band(const Band& band) {
  if (!(band.low_Hz >= 0 && band.low_Hz < band.high_Hz && std::isfinite(band.high_Hz))) {
    throw InputError("the band is not a range of frequencies", kOptions, "give two frequencies in Hz, the lower first",
                     {"band"});
  }
}

void require_not_negative(double value, const char* field, std::vector<OptionId> options) {
  if (!(value >= 0 && std::isfinite(value)))
    throw InputError("the value is below 0, or not a finite number", field, "give 0 or more", std::move(options));
}

void require_consistent(const AnalysisOptions& options) {
  constexpr double kMinFraction = 1e-12;
  if (options.band_Hz) require_band(*options.band_Hz);
  const HitOptions& hits = options.hits;
  require_not_negative(hits.from_s, "HitOptions::from_s", {"from"});
  require_not_negative(hits.pretrigger_s.value_or(0), "HitOptions::pretrigger_s", {"pretrigger"});
  if (hits.to_s && !(*hits.to_s > hits.from_s)) {
    throw InputError("the end of the time range is not after its start", kOptions,
                     "give seconds from each row's beginning", {"from", "to"});
  }
  for (const std::size_t hit : hits.accept_hit) {
    if (std::find(hits.reject_hit.begin(), hits.reject_hit.end(), hit) != hits.reject_hit.end()) {
      throw InputError("hit " + std::to_string(hit + 1) + " is both accepted and rejected", kOptions, "name it once",
                       {"accept_hit", "reject_hit"});
    }
  }
  for (const double start : options.start_Hz) {
    const bool within = !options.band_Hz || (start >= options.band_Hz->low_Hz && start <= options.band_Hz->high_Hz);
    if (!(start > 0) || !within) {
      throw InputError("a start frequency lies outside the band", kOptions,
                       "widen the band, or leave the frequency out", {"start", "band"});
    }
  }
  if (options.exponential != 0 && !(options.exponential >= kMinFraction && options.exponential < 1)) {
    throw InputError("the final value of the exponential window is not a fraction", kOptions,
                     "give a number between 0 and 1", {"exponential"});
  }
  for (const double delay_s : options.delay_s) {
    if (!std::isfinite(delay_s))
      throw InputError("a delay is not a number", kOptions, "give seconds after the force", {"delay"});
  }
  if (options.auto_delay && !options.delay_s.empty())
    throw InputError("delay_s and auto_delay are both set", kOptions, "set one of them", {"delay"});
  if (options.modes && *options.modes == 0)
    throw InputError("the number of modes is 0", kOptions, "give 1 or more", {"modes"});
  require_above_zero(options.overlay_dB, "AnalysisOptions::overlay_dB", {"overlay_db"});
  if (options.budget && !(options.budget->time_s > 0 && options.budget->memory_bytes > 0))
    throw InputError("the budget is not above 0", kOptions, "give a time and a memory above 0", {"budget"});
  require_above_zero(hits.trigger_N.value_or(1), "HitOptions::trigger_N", {"trigger"});
  require_above_zero(hits.length_s.value_or(1), "HitOptions::length_s", {"length"});
}

identify::ObjectKind object_of(ObjectKind object) {
  if (object == ObjectKind::tube) return identify::ObjectKind::tube;
  return object == ObjectKind::other ? identify::ObjectKind::other : identify::ObjectKind::automatic;
}

}  // namespace

void require_above_zero(double value, const char* field, std::vector<OptionId> options) {
  if (!(value > 0 && std::isfinite(value)))
    throw InputError("the value is not above 0", field, "give a number above 0", std::move(options));
}

pipeline::AnalysisOptions analysis_options(const AnalysisOptions& options) {
  require_consistent(options);
  pipeline::AnalysisOptions out;
  if (options.band_Hz) out.band_Hz = {options.band_Hz->low_Hz, options.band_Hz->high_Hz};
  out.estimator = estimator_of(options.estimator);
  out.hits = {.trigger_N = options.hits.trigger_N,
              .pretrigger_s = options.hits.pretrigger_s,
              .length_s = options.hits.length_s,
              .from_s = options.hits.from_s,
              .to_s = options.hits.to_s,
              .gate_force = options.hits.force_window};
  out.accept_hits = options.hits.accept_hit;
  out.reject_hits = options.hits.reject_hit;
  out.exponential_end = options.exponential;
  out.delays = {.automatic = options.auto_delay, .delay_s = options.delay_s};
  std::vector<double> start_Hz = options.start_Hz;
  std::sort(start_Hz.begin(), start_Hz.end());
  start_Hz.erase(std::unique(start_Hz.begin(), start_Hz.end()), start_Hz.end());
  out.modes = {.effort = effort_of(options.effort), .modes = options.modes, .start_Hz = std::move(start_Hz)};
  out.classes.overlay_dB = options.overlay_dB;
  out.classes.object = object_of(options.object);
  out.threads = options.threads;
  out.budget = options.budget;
  return out;
}

}  // namespace percuss::api
