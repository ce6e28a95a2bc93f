#include "report/json/analysis_options_json.hpp"

#include <nlohmann/json.hpp>

#include "pipeline/hits/hit_grading.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json hits_json(const std::vector<std::size_t>& hits) {
  Json json = Json::array();
  for (const std::size_t hit : hits) json.push_back(hit == pipeline::kEveryHit ? Json("all") : Json(hit));
  return json;
}

}  // namespace

Json options_json(const pipeline::AnalysisOptions& o) {
  Json json = Json::object();
  if (!o.accept_hits.empty()) json["accept_hits"] = hits_json(o.accept_hits);
  if (!o.reject_hits.empty()) json["reject_hits"] = hits_json(o.reject_hits);
  if (o.estimator != frf::Estimator::h1) json["estimator"] = name_of(o.estimator);
  if (o.modes.modes) json["modes"] = *o.modes.modes;
  if (!o.modes.start_Hz.empty()) json["start_hz"] = o.modes.start_Hz;
  if (o.hits.trigger_N) json["trigger_n"] = *o.hits.trigger_N;
  if (o.hits.pretrigger_s) json["pretrigger_s"] = *o.hits.pretrigger_s;
  if (o.hits.length_s) json["length_s"] = *o.hits.length_s;
  if (o.hits.from_s > 0) json["from_s"] = o.hits.from_s;
  if (o.hits.to_s) json["to_s"] = *o.hits.to_s;
  if (!o.hits.gate_force) json["force_window"] = "off";
  if (o.exponential_end > 0) json["exponential_end"] = o.exponential_end;
  if (o.delays.automatic) json["delay"] = "auto";
  if (!o.delays.delay_s.empty()) json["delay"] = o.delays.delay_s;
  if (o.classes.overlay_dB != identify::ClassifyOptions{}.overlay_dB) json["overlay_db"] = o.classes.overlay_dB;
  if (o.classes.object != identify::ObjectKind::automatic)
    json["object"] = o.classes.object == identify::ObjectKind::tube ? "tube" : "other";
  return json;
}

}  // namespace percuss::report
