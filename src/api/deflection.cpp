#include "percuss/deflection.hpp"

#include <utility>

#include "api/handles.hpp"
#include "pipeline/impacts.hpp"
#include "report/deflection_report.hpp"

namespace percuss {
namespace api {
namespace {

metrics::DeflectionMethod method_of(DeflectionMethod method) {
  switch (method) {
    case DeflectionMethod::small_interval:
      return metrics::DeflectionMethod::small_interval;
    case DeflectionMethod::drift_free:
      return metrics::DeflectionMethod::drift_free;
    case DeflectionMethod::frequency:
      return metrics::DeflectionMethod::frequency;
    case DeflectionMethod::modal:
      return metrics::DeflectionMethod::modal;
    case DeflectionMethod::automatic:
      break;
  }
  return metrics::DeflectionMethod::automatic;
}

pipeline::ImpactTestOptions impact_options(const DeflectionOptions& options) {
  return {.deflection = {.method = method_of(options.method),
                         .highpass_corner_Hz = options.highpass_corner_Hz,
                         .lowest_Hz = options.lowest_Hz,
                         .free_body = options.free_body},
          .effective_mass_kg = options.effective_mass_kg,
          .beam_distance_m = options.beam_distance_m,
          .beam_time_s = options.beam_time_s,
          .position_m = options.positions_m};
}

std::shared_ptr<const DeflectionData> deflection_data(const Record& record, const DeflectionOptions& options) {
  const pipeline::AnalysisOptions analysis_of = analysis_options(options.analysis);
  std::shared_ptr<const AnalysisData> analysis(
      new AnalysisData{pipeline::Analysis(record_of_one_run(record), analysis_of)});
  if (auto without_force = pipeline::record_without_idle_force(analysis->analysis))
    analysis.reset(new AnalysisData{pipeline::Analysis(*std::move(without_force), analysis_of)});
  pipeline::ImpactTest test = pipeline::deflect(analysis->analysis, impact_options(options));
  return std::make_shared<const DeflectionData>(DeflectionData{analysis, std::move(test)});
}

}  // namespace
}  // namespace api

Deflections::Deflections(const Record& record, const DeflectionOptions& options)
    : data_(api::deflection_data(record, options)) {}

std::vector<HitDeflection> Deflections::hits() const {
  const double fs_Hz = data_->analysis->analysis.record().fs_Hz;
  std::vector<HitDeflection> out;
  for (const pipeline::DeflectedHit& hit : data_->test.hits) {
    out.push_back({.hit = hit.hit,
                   .channel = hit.channel,
                   .point = hit.point,
                   .first_s = hit.first_s,
                   .velocity_mps = hit.deflection.velocity_mps,
                   .deflection_m = hit.deflection.deflection_m,
                   .std_m = hit.deflection.std_m,
                   .peak_m = hit.deflection.peak_m,
                   .peak_std_m = hit.deflection.peak_std_m,
                   .peak_time_s = hit.first_s + static_cast<double>(hit.deflection.peak) / fs_Hz});
  }
  return out;
}

std::vector<PointDeflection> Deflections::points() const {
  std::vector<PointDeflection> out;
  for (const pipeline::PointDeflection& at : data_->test.points) {
    out.push_back({.point = at.point,
                   .channel = at.channel,
                   .hits = at.hits,
                   .position_m = at.position_m,
                   .peak_m = at.peak_m,
                   .std_m = at.std_m});
  }
  return out;
}

std::vector<ImpactSpeed> Deflections::speeds() const {
  std::vector<ImpactSpeed> out;
  for (const pipeline::ImpactSpeed& speed : data_->test.speeds)
    out.push_back({.hit = speed.hit, .speed_mps = speed.speed_mps, .std_mps = speed.std_mps});
  return out;
}

std::vector<Warning> Deflections::warnings() const { return api::warnings_of(data_->test.warnings); }

std::string Deflections::json() const { return report::deflection_json(data_->analysis->analysis, data_->test); }

}  // namespace percuss
