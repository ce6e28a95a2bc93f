#include "report/json/deflection_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/json/result_json.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/deflection_text.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

Json peak_direction_json(double peak_m) { return std::isnan(peak_m) ? Json() : Json(peak_m < 0 ? -1 : 1); }

Json deflected_hit_json(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit) {
  const metrics::Deflection& d = hit.deflection;
  const bool has_peak = d.has_peak();
  return {{"index", hit.hit},
          {"channel", hit.channel},
          {"point", hit.point},
          {"position_m", or_null(hit.position_m)},
          {"peak_m", std::abs(d.peak_m)},
          {"peak_time_s", has_peak ? Json(sample_time_s(analysis, hit, d.peak)) : Json()},
          {"peak_std_m", d.std_m.empty() ? Json() : Json(d.peak_std_m)},
          {"direction", peak_direction_json(d.peak_m)},
          {"forward_m", std::abs(d.forward_m)},
          {"forward_std_m", d.std_m.empty() ? Json() : Json(d.forward_std_m)},
          {"method", name_of(d.method)},
          {"bias_mps2", d.bias_mps2},
          {"drift_m", d.drift_m},
          {"held", d.zero_mean_corrected}};
}

}  // namespace

std::string deflection_json(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test) {
  Json json{{"schema", "percuss/deflection/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const acquire::InputFile& file : analysis.record().files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  json["fs_hz"] = analysis.record().fs_Hz;
  json["hits"] = Json::array();
  for (const pipeline::DeflectedHit& hit : test.hits) json["hits"].push_back(deflected_hit_json(analysis, hit));
  json["points"] = Json::array();
  for (const pipeline::PointDeflection& point : test.points) {
    json["points"].push_back({{"point", point.point},
                              {"channel", point.channel},
                              {"position_m", or_null(point.position_m)},
                              {"hits", point.hits},
                              {"peak_m", std::abs(point.peak_m)},
                              {"peak_std_m", point.std_m},
                              {"direction", peak_direction_json(point.peak_m)},
                              {"directions_differ", point.directions_differ},
                              {"forward_m", point.forward_m},
                              {"forward_std_m", point.forward_std_m}});
  }
  json["impact_speeds"] = Json::array();
  for (const pipeline::ImpactSpeed& speed : test.speeds) {
    json["impact_speeds"].push_back(
        {{"index", speed.hit}, {"speed_mps", speed.speed_mps}, {"speed_std_mps", speed.std_mps}});
  }
  json["warnings"] = Json::array();
  for (const pipeline::Warning& warning : test.warnings) json["warnings"].push_back(warning_json(warning));
  return indented_text(json) + "\n";
}

std::string with_comparison(const std::string& document, const std::vector<identify::Mode>& modes,
                            const std::string& comparison) {
  Json json = Json::parse(document);
  json["modes"] = Json::array();
  for (std::size_t m = 0; m < modes.size(); ++m) json["modes"].push_back(Json::parse(mode_json(modes[m], m, {})));
  json["comparison"] = Json::parse(comparison);
  return indented_text(json) + "\n";
}

}  // namespace percuss::report
