#include "report/impact_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/units.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

struct SweptName {
  const char *key, *label;
};
constexpr std::array<SweptName, 5> kSwept{{{"ei", "EI, N·m²"},
                                           {"torsion", "torsion spring, N·m/rad"},
                                           {"rho_a", "mass per length, kg/m"},
                                           {"at", "impact from the spring's end, m"},
                                           {"speed", "ball speed, m/s"}}};

constexpr double kEmptyField = std::numeric_limits<double>::quiet_NaN();  // an empty field of the table

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

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
  json["recontact_time_s"] = optional_json(r.recontact_s);
  json["contacts"] = r.contacts;
  json["last_separation_s"] = r.last_separation_s;
  json["final_cor"] = optional_json(r.final_cor);
  json["energy_error"] = r.energy_error;
}

Json document(double speed_mps, const model::ImpactResult& result, const std::vector<ImpactSweep>& sweeps) {
  Json json{{"schema", "percuss/model-impact/1"}, {"version", version()}};
  add_result(json, result);
  json["cor_uncertainty"] = optional_json(result.cor_uncertainty);
  json["final_cor_uncertainty"] = optional_json(result.final_cor_uncertainty);
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

std::string recontact_text(const model::ImpactResult& r) {
  return r.recontact_s ? fmt::format("after {:.1f} ms", 1000 * *r.recontact_s) : "none";
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

TextTable sweep_table(const ImpactSweep& sweep) {
  const bool several =
      std::any_of(sweep.results.begin(), sweep.results.end(), [](const auto& r) { return r.contacts > 1; });
  std::vector<TextTable::Column> heads{
      {sweep.parameter, TextTable::Align::right}, {"restitution", TextTable::Align::right},
      {"contact", TextTable::Align::right},       {"force", TextTable::Align::right},
      {"deflection", TextTable::Align::right},    {"second contact"}};
  if (several) heads.push_back({"restitution at last", TextTable::Align::right});
  TextTable table(std::move(heads));
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const model::ImpactResult& r = sweep.results[i];
    std::vector<std::string> cells{
        fmt::format("{:.6g}", sweep.values[i]),
        fmt::format("{:.4f}", r.cor),
        fmt::format("{:.3f} ms", 1000 * r.contact_s),
        fmt::format("{:.4g} N", r.peak_force_N),
        r.flies_off ? "flies off" : fmt::format("{:.3f} mm", 1000 * std::abs(r.peak_deflection_m)),
        recontact_text(r)};
    if (several) cells.push_back(r.final_cor ? fmt::format("{:.4f}", *r.final_cor) : "not known");
    table.add(std::move(cells));
  }
  return table;
}

std::vector<NumericColumn> series_columns(const std::vector<model::ImpactMoment>& series) {
  std::vector<NumericColumn> columns{
      {"time_s", {}}, {"deflection_m", {}}, {"force_n", {}}, {"ball_speed_mps", {}}, {"ball_m", {}}};
  for (NumericColumn& column : columns) column.values.reserve(series.size());
  for (const model::ImpactMoment& moment : series) {
    columns[0].values.push_back(moment.time_s);
    columns[1].values.push_back(moment.beam_m);
    columns[2].values.push_back(moment.force_N);
    columns[3].values.push_back(moment.ball_speed_mps);
    columns[4].values.push_back(moment.ball_m);
  }
  return columns;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> out = values;
  for (double& value : out) value *= factor;
  return out;
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

// A row per impact of all sweeps; parameters that a sweep does not vary keep their value.
std::vector<NumericColumn> sweep_columns(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps) {
  std::vector<NumericColumn> columns;
  columns.reserve(kSwept.size() + 8);
  for (const SweptName& name : kSwept) columns.push_back({name.key, {}});
  for (const char* name : {"cor", "contact_s", "peak_force_n", "peak_deflection_m", "peak_deflection_time_s",
                           "recontact_time_s", "final_cor", "contacts"})
    columns.push_back({name, {}});
  for (const ImpactSweep& sweep : sweeps) {
    for (std::size_t i = 0; i < sweep.values.size(); ++i) {
      model::Impact varied = impact;
      *swept_value(varied, sweep.parameter) = sweep.values[i];
      std::size_t c = 0;
      for (const SweptName& name : kSwept) columns[c++].values.push_back(*swept_value(varied, name.key));
      const model::ImpactResult& r = sweep.results[i];
      for (const double value :
           {r.cor, r.contact_s, r.peak_force_N, std::abs(r.peak_deflection_m), r.peak_deflection_time_s,
            r.recontact_s.value_or(kEmptyField), r.final_cor.value_or(kEmptyField), static_cast<double>(r.contacts)})
        columns[c++].values.push_back(value);
    }
  }
  return columns;
}

// Each sweep as a curve of the value `of` a result.
LineChart sweep_chart(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps, LineChart chart,
                      const std::function<double(const model::ImpactResult&)>& of) {
  model::Impact base = impact;
  for (const ImpactSweep& sweep : sweeps) {
    ChartCurve curve{.name = sweep.parameter, .x = sweep.values, .marks = true};
    if (sweeps.size() > 1) curve.x = scaled(sweep.values, 1 / *swept_value(base, sweep.parameter));
    curve.y.reserve(sweep.results.size());
    for (const model::ImpactResult& result : sweep.results) curve.y.push_back(of(result));
    chart.curves.push_back(std::move(curve));
  }
  chart.x.label = "parameter over its value without a sweep";
  for (const SweptName& name : kSwept) {
    if (sweeps.size() == 1 && sweeps.front().parameter == name.key) chart.x.label = name.label;
  }
  return chart;
}

// Restitution and, unless the beam flies off, deflection over the parameters.
std::vector<LineChart> sweep_charts(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps,
                                    bool flies_off) {
  std::vector<LineChart> charts{sweep_chart(impact, sweeps,
                                            {.title = "Ball on beam", .y = {.label = "coefficient of restitution"}},
                                            [](const model::ImpactResult& r) { return r.cor; })};
  if (!flies_off) {
    charts.push_back(sweep_chart(impact, sweeps,
                                 {.title = "Deflection of the struck point", .y = {.label = "largest deflection, mm"}},
                                 [](const model::ImpactResult& r) { return 1000 * std::abs(r.peak_deflection_m); }));
  }
  return charts;
}

}  // namespace

double* swept_value(model::Impact& impact, const std::string& parameter) {
  if (parameter == "ei") return &impact.beam.stiffness_Nm2;
  if (parameter == "torsion") return &impact.beam.torsion_Nmprad;
  if (parameter == "rho_a") return &impact.beam.mass_per_length_kgpm;
  if (parameter == "at") return &impact.at_m;
  return parameter == "speed" ? &impact.speed_mps : nullptr;
}

CommandReport impact_report(const model::Impact& impact, const model::ImpactResult& result,
                            const std::vector<ImpactSweep>& sweeps, const model::BeamStructure* shaped,
                            const StructureOrigin& origin) {
  CommandReport report;
  Json json = document(impact.speed_mps, result, sweeps);
  if (shaped != nullptr) {
    std::vector<double> elastic_Hz;
    for (const double omega : result.omega_radps) {
      if (omega > 0) elastic_Hz.push_back(omega / kTwoPi);
    }
    add_structure_json(*shaped, origin, elastic_Hz, json);
    add_structure_text(*shaped, origin, elastic_Hz, "x = 0", report.text);
  }
  report.json = json.dump(2) + "\n";
  report.text += result_text(impact, result);
  for (const ImpactSweep& sweep : sweeps) {
    report.text += "\n";
    report.text += sweep_table(sweep);
  }
  report.columns = sweeps.empty() ? series_columns(result.series) : sweep_columns(impact, sweeps);
  report.charts = sweeps.empty() ? std::vector<LineChart>{series_chart(report.columns)}
                                 : sweep_charts(impact, sweeps, result.flies_off);
  return report;
}

}  // namespace percuss::report
