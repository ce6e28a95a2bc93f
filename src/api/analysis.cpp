#include "percuss/analysis.hpp"

#include <utility>

#include "api/handles.hpp"
#include "core/parallel/parallel.hpp"
#include "pipeline/run_analyses.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "report/frf_files.hpp"
#include "report/json/analysis_json.hpp"
#include "report/text/analysis_text.hpp"

namespace percuss {
namespace api {
namespace {

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
    ModeClassification to{.type = type_of(from.type),
                          .order = from.order,
                          .confidence = from.confidence,
                          .overlay_dB = from.overlay_dB,
                          .overlaid = from.overlaid,
                          .ratio = from.ratio,
                          .ratio_std = from.ratio_std,
                          .possible_three_waves = from.possible_three_waves,
                          .order_uncertain = from.order_uncertain};
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

std::vector<Warning> warnings_of(const std::vector<warnings::Warning>& warnings) {
  std::vector<Warning> out;
  out.reserve(warnings.size());
  for (const warnings::Warning& warning : warnings) {
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
