#include "report/impact_report.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

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

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

// Members of the document for one impact, and for each impact of a sweep.
void add_result(Json& json, const model::ImpactResult& r) {
  json["cor"] = r.cor;
  json["contact_s"] = r.contact_s;
  json["peak_force_n"] = r.peak_force_N;
  json["peak_deflection_m"] = std::abs(r.peak_deflection_m);
  json["peak_deflection_time_s"] = r.peak_deflection_time_s;
  json["peak_deflection_direction"] = r.peak_deflection_m < 0 ? -1 : 1;
  json["forward_deflection_m"] = r.forward_deflection_m;
  json["forward_deflection_time_s"] = r.forward_deflection_time_s;
  json["recontact"] = r.recontact_s.has_value();
  json["recontact_time_s"] = optional_json(r.recontact_s);
  json["energy_error"] = r.energy_error;
}

std::string document(const model::ImpactResult& result, const std::vector<ImpactSweep>& sweeps) {
  Json json{{"schema", "percuss/model-impact/1"}, {"version", version()}};
  add_result(json, result);
  json["cor_uncertainty"] = optional_json(result.cor_uncertainty);
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
  return json.dump(2) + "\n";
}

std::string recontact_text(const model::ImpactResult& r) {
  return r.recontact_s ? fmt::format("after {:.1f} ms", 1000 * *r.recontact_s) : "none";
}

std::string result_text(const model::Impact& impact, const model::ImpactResult& r) {
  std::string text = fmt::format(
      "coefficient of restitution {:.5f} at the first separation, after {:.3f} ms of contact\n"
      "ball speed {:.4g} m/s before and {:.4g} m/s after impact{}\n"
      "largest force {:.5g} N; largest deflection of the struck point {:.4g} mm {} the ball's motion, {:.2f} ms after "
      "first touch\n"
      "second contact: {}\nerror of the energy balance {:.1e}",
      r.cor, 1000 * r.contact_s, impact.speed_mps, std::abs(r.cor) * impact.speed_mps,
      r.cor < 0 ? " in the same direction" : "", r.peak_force_N, 1000 * std::abs(r.peak_deflection_m),
      r.peak_deflection_m < 0 ? "against" : "along", 1000 * r.peak_deflection_time_s, recontact_text(r),
      r.energy_error);
  if (r.lost_J > 0) text += fmt::format("; {:.4g} J lost in the contact", r.lost_J);
  return text + "\n";
}

TextTable sweep_table(const ImpactSweep& sweep) {
  TextTable table({{sweep.parameter, TextTable::Align::right},
                   {"restitution", TextTable::Align::right},
                   {"contact", TextTable::Align::right},
                   {"force", TextTable::Align::right},
                   {"deflection", TextTable::Align::right},
                   {"second contact"}});
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    const model::ImpactResult& r = sweep.results[i];
    table.add({fmt::format("{:.6g}", sweep.values[i]), fmt::format("{:.4f}", r.cor),
               fmt::format("{:.3f} ms", 1000 * r.contact_s), fmt::format("{:.4g} N", r.peak_force_N),
               fmt::format("{:.3f} mm", 1000 * std::abs(r.peak_deflection_m)), recontact_text(r)});
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
  columns.reserve(kSwept.size() + 6);
  for (const SweptName& name : kSwept) columns.push_back({name.key, {}});
  for (const char* name :
       {"cor", "contact_s", "peak_force_n", "peak_deflection_m", "peak_deflection_time_s", "recontact_time_s"})
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
            r.recontact_s.value_or(std::numeric_limits<double>::quiet_NaN())})
        columns[c++].values.push_back(value);
    }
  }
  return columns;
}

LineChart sweep_chart(const model::Impact& impact, const std::vector<ImpactSweep>& sweeps) {
  LineChart chart{.title = "Ball on beam", .y = {.label = "coefficient of restitution"}};
  model::Impact base = impact;
  for (const ImpactSweep& sweep : sweeps) {
    ChartCurve curve{.name = sweep.parameter, .x = sweep.values, .marks = true};
    if (sweeps.size() > 1) curve.x = scaled(sweep.values, 1 / *swept_value(base, sweep.parameter));
    curve.y.reserve(sweep.results.size());
    for (const model::ImpactResult& result : sweep.results) curve.y.push_back(result.cor);
    chart.curves.push_back(std::move(curve));
  }
  chart.x.label = "parameter over its value without a sweep";
  for (const SweptName& name : kSwept) {
    if (sweeps.size() == 1 && sweeps.front().parameter == name.key) chart.x.label = name.label;
  }
  return chart;
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
                            const std::vector<ImpactSweep>& sweeps) {
  CommandReport report;
  report.json = document(result, sweeps);
  report.text = result_text(impact, result);
  for (const ImpactSweep& sweep : sweeps) {
    report.text += "\n";
    report.text += sweep_table(sweep);
  }
  report.columns = sweeps.empty() ? series_columns(result.series) : sweep_columns(impact, sweeps);
  report.charts = {sweeps.empty() ? series_chart(report.columns) : sweep_chart(impact, sweeps)};
  return report;
}

}  // namespace percuss::report
