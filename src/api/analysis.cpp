#include "percuss/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/handles.hpp"
#include "core/error.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "report/frf_files.hpp"
#include "report/json/analysis_json.hpp"
#include "report/text/analysis_text.hpp"

namespace percuss {
namespace api {
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

void require_consistent(const AnalysisOptions& options) {
  constexpr double kMinFraction = 1e-12;
  if (options.band_Hz) require_band(*options.band_Hz);
  const HitOptions& hits = options.hits;
  if (hits.to_s && *hits.to_s <= hits.from_s) {
    throw InputError("the end of the time range is not after its start", kOptions,
                     "give seconds from each row's beginning", {"from", "to"});
  }
  for (const std::size_t hit : hits.accept_hit) {
    if (std::find(hits.reject_hit.begin(), hits.reject_hit.end(), hit) != hits.reject_hit.end()) {
      throw InputError("hit " + std::to_string(hit) + " is both accepted and rejected", kOptions, "name it once",
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

// The analysis of a record or of FRFs, with assumed angles where none are stated.
template <class AnyRecord>
pipeline::Analysis with_angles(AnyRecord record, pipeline::AnalysisOptions options) {
  pipeline::assume_angles(record, options.classes);
  return {std::move(record), std::move(options)};
}

ModeType type_of(identify::ModeType type) {
  if (type == identify::ModeType::bending) return ModeType::bending;
  return type == identify::ModeType::hoop ? ModeType::hoop : ModeType::unknown;
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

std::vector<Mode> modes_of(const std::vector<identify::Mode>& modes) {
  std::vector<Mode> out;
  for (const identify::Mode& mode : modes) {
    out.push_back({.index = out.size(),
                   .freq_Hz = mode.pole.freq_Hz,
                   .freq_std_Hz = mode.freq_std_Hz,
                   .damping_ratio = mode.pole.damping_ratio,
                   .damping_ratio_std = mode.damping_std,
                   .freq_scatter_Hz = mode.freq_scatter_Hz,
                   .residues = {}});
    for (const identify::Residue& residue : mode.residues) {
      out.back().residues.push_back({.point = residue.point,
                                     .channel = residue.channel,
                                     .value_per_kg = residue.value,
                                     .std_per_kg = identify::total_std(residue)});
    }
  }
  return out;
}

std::vector<ModeClassification> classifications_of(const std::vector<identify::ModeClassification>& classifications) {
  std::vector<ModeClassification> out;
  for (const identify::ModeClassification& from : classifications) {
    ModeClassification to{.type = type_of(from.family),
                          .order = from.order,
                          .confidence = from.confidence,
                          .overlay_dB = from.overlay_dB,
                          .overlaid = from.overlaid,
                          .ratio = from.ratio,
                          .ratio_std = from.ratio_std};
    if (from.alternative) to.alternative = type_of(*from.alternative);
    if (from.split_mode) {
      to.split_mode = SplitMode{.partner = from.split_mode->partner,
                                .separation_Hz = from.split_mode->separation_Hz,
                                .separation_std_Hz = from.split_mode->separation_std_Hz,
                                .first = from.split_mode->first,
                                .quoted = from.split_mode->quoted};
    }
    out.push_back(to);
  }
  return out;
}

std::vector<Warning> warnings_of(const std::vector<pipeline::Warning>& warnings) {
  std::vector<Warning> out;
  out.reserve(warnings.size());
  for (const pipeline::Warning& warning : warnings) {
    out.push_back({.code = warning.code,
                   .message = warning.message,
                   .options = warning.options,
                   .remedy = warning.remedy,
                   .severity = severity_of(warning.severity.value_or(pipeline::severity_of(warning.code)))});
  }
  return out;
}

}  // namespace api

const char* name_of(ModeType type) {
  if (type == ModeType::bending) return "bending";
  return type == ModeType::hoop ? "hoop" : "unknown";
}

Analysis::Analysis(const Record& record, const AnalysisOptions& options)
    : data_(new api::AnalysisData{api::with_angles(api::record_of_one_run(record), api::analysis_options(options))}) {}

Analysis::Analysis(const FrfSet& frfs, const AnalysisOptions& options)
    : data_(new api::AnalysisData{api::with_angles(frfs.data().record, api::analysis_options(options))}) {}

bool Analysis::possible() const { return data_->analysis.possible(); }
std::vector<Hit> Analysis::hits() const { return api::hits_of(data_->analysis.hits()); }

Band Analysis::band_Hz() const {
  const auto [low_Hz, high_Hz] = data_->analysis.band_Hz();
  return {low_Hz, high_Hz};
}

FrfSet Analysis::frfs() const {
  const ThreadLimit limit(data_->analysis.options().threads);
  return api::make_frf_set(report::frf_record_of(data_->analysis), FrfKind::accelerance);
}

std::vector<int> Analysis::points() const { return data_->analysis.frf_points(); }

std::vector<Mode> Analysis::modes() const {
  const ThreadLimit limit(data_->analysis.options().threads);
  return api::modes_of(data_->analysis.modes());
}

std::vector<ModeClassification> Analysis::classifications() const {
  const ThreadLimit limit(data_->analysis.options().threads);
  return api::classifications_of(data_->analysis.classifications());
}

std::vector<ModeOfHit> Analysis::modes_per_hit() const {
  const ThreadLimit limit(data_->analysis.options().threads);
  std::vector<ModeOfHit> out;
  for (const pipeline::HitMode& mode : data_->analysis.modes_per_hit()) {
    out.push_back({.hit = mode.hit,
                   .mode = mode.mode,
                   .freq_Hz = mode.pole.freq_Hz,
                   .freq_std_Hz = mode.freq_std_parts_Hz.total(),
                   .damping_ratio = mode.pole.damping_ratio,
                   .damping_ratio_std = mode.damping_std_parts.total()});
  }
  return out;
}

std::vector<Warning> Analysis::warnings() const {
  const ThreadLimit limit(data_->analysis.options().threads);
  data_->analysis.hits();  // warnings are about the results computed so far
  if (possible()) data_->analysis.classifications();
  return api::warnings_of(data_->analysis.warnings());
}

std::string Analysis::json(const JsonOptions& options) const {
  const ThreadLimit limit(data_->analysis.options().threads);
  return report::analysis_json(data_->analysis, {.per_hit = options.per_hit, .stabilisation = options.stabilisation});
}

std::string Analysis::text(std::size_t width) const {
  const ThreadLimit limit(data_->analysis.options().threads);
  return report::analysis_text(data_->analysis, {.width = width});
}

}  // namespace percuss
