#include "report/impact_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/units.hpp"
#include "report/impact_sweep_report.hpp"
#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Members of the document for one impact, and for each impact of a sweep.
void add_result(Json& json, const model::ImpactResult& r) {
  json["cor"] = r.cor;
  json["contact_s"] = r.contact_s;
  json["peak_force_n"] = r.peak_force_N;
  const auto unless_flying = [&](double value) { return r.flies_off ? Json() : Json(value); };
  json["peak_deflection_m"] = unless_flying(std::abs(r.peak_deflection_m));
  json["peak_deflection_time_s"] = unless_flying(r.peak_deflection_time_s);
  json["peak_deflection_direction"] = r.flies_off ? Json() : Json(r.peak_deflection_m < 0 ? -1 : 1);
  json["forward_deflection_m"] = unless_flying(r.forward_deflection_m);
  json["forward_deflection_time_s"] = unless_flying(r.forward_deflection_time_s);
  json["flies_off"] = r.flies_off;
  json["recontact"] = r.recontact_s.has_value();
  json["recontact_time_s"] = or_null(r.recontact_s);
  json["contacts"] = r.contacts;
  json["last_separation_s"] = r.last_separation_s;
  json["final_cor"] = or_null(r.final_cor);
  json["energy_error"] = r.energy_error;
}

Json document(double speed_mps, const model::ImpactResult& result, const std::vector<ImpactSweep>& sweeps) {
  Json json{{"schema", "percuss/model-impact/1"}, {"version", version()}};
  add_result(json, result);
  json["cor_uncertainty"] = or_null(result.cor_uncertainty);
  json["final_cor_uncertainty"] = or_null(result.final_cor_uncertainty);
  json["final_ball_speed_mps"] = result.final_cor ? Json(-*result.final_cor * speed_mps) : Json();
  json["lost_j"] = result.lost_J;
  json["steps"] = result.steps;
  json["frequency_hz"] = Json::array();
  for (const double omega : result.omega_radps) json["frequency_hz"].push_back(omega / kTwoPi);
  if (!sweeps.empty()) json["sweep"] = Json::array();
  for (const ImpactSweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      Json entry{{sweep.parameter, sweep.values[i]}};
      add_result(entry, sweep.results[i]);
      json["sweep"].push_back(std::move(entry));
    }
  }
  return json;
}

// The ball's speed after a contact. Says so where the ball keeps its direction.
std::string speed_text(double cor, double speed_mps) {
  return fmt::format("{:.4g} m/s{}", std::abs(cor) * speed_mps, cor < 0 ? " in the same direction" : "");
}

std::string deflection_text(const model::ImpactResult& r) {
  if (r.flies_off) return "the beam flies off: its deflection has no maximum";
  return fmt::format(
      "largest deflection of the struck point {:.4g} mm {} the ball's motion, {:.2f} ms after first touch",
      1000 * std::abs(r.peak_deflection_m), r.peak_deflection_m < 0 ? "against" : "along",
      1000 * r.peak_deflection_time_s);
}

std::string contacts_text(const model::Impact& impact, const model::ImpactResult& r) {
  if (r.contacts == 1) return "second contact: " + recontact_text(r);
  if (!r.final_cor)
    return fmt::format("second contact: {}; {} contacts were followed, and no last one was found", recontact_text(r),
                       r.contacts);
  return fmt::format(
      "second contact: {}; the ball leaves for good after {} contacts and {:.1f} ms, with {}: coefficient of "
      "restitution {:.5f}",
      recontact_text(r), r.contacts, 1000 * r.last_separation_s, speed_text(*r.final_cor, impact.speed_mps),
      *r.final_cor);
}

std::string result_text(const model::Impact& impact, const model::ImpactResult& r) {
  std::string text = fmt::format(
      "coefficient of restitution {:.5f} at the first separation, after {:.3f} ms of contact\n"
      "ball speed {:.4g} m/s before and {} after {}\n"
      "largest force {:.5g} N; {}\n{}\nerror of the energy balance {:.1e}",
      r.cor, 1000 * r.contact_s, impact.speed_mps, speed_text(r.cor, impact.speed_mps),
      r.contacts > 1 ? "the first contact" : "impact", r.peak_force_N, deflection_text(r), contacts_text(impact, r),
      r.energy_error);
  if (r.lost_J > 0) text += fmt::format("; {:.4g} J lost in the contact", r.lost_J);
  return text + "\n";
}

LineChart series_chart(const std::vector<NumericColumn>& columns) {
  const std::vector<double> time_ms = scaled(columns[0].values, 1000);
  return {.title = "Ball on beam",
          .x = {.label = "time after first touch, ms"},
          .y = {.label = "deflection in cm, force in kN, speed in m/s"},
          .curves = {{"beam, cm", time_ms, scaled(columns[1].values, 100)},
                     {"force, kN", time_ms, scaled(columns[2].values, 1e-3)},
                     {"ball, m/s", time_ms, columns[3].values}}};
}

}  // namespace

CommandReport impact_report(const model::Impact& impact, const model::ImpactResult& result,
                            const std::vector<ImpactSweep>& sweeps, const model::BeamStructure* nonuniform,
                            const StructureOrigin& origin) {
  CommandReport report;
  Json json = document(impact.speed_mps, result, sweeps);
  if (nonuniform != nullptr) {
    std::vector<double> elastic_Hz;
    for (const double omega : result.omega_radps) {
      if (omega > 0) elastic_Hz.push_back(omega / kTwoPi);
    }
    add_structure_json(*nonuniform, origin, elastic_Hz, json);
    add_structure_text(*nonuniform, origin, elastic_Hz, "x = 0", report.text);
  }
  report.json = indented_text(json) + "\n";
  report.text += result_text(impact, result);
  for (const ImpactSweep& sweep : sweeps) {
    report.text += "\n";
    report.text += sweep_table(sweep);
  }
  report.columns = sweeps.empty() ? series_columns(result.series) : impact_sweep_columns(impact, sweeps);
  report.charts = sweeps.empty() ? std::vector<LineChart>{series_chart(report.columns)}
                                 : impact_sweep_charts(impact, sweeps, result.flies_off);
  return report;
}

}  // namespace percuss::report
