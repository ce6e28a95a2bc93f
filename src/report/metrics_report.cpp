#include "report/metrics_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/number_format.hpp"
#include "report/text/numeric_csv.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, metrics::kReadings> kReadingNames{"length_in",  "weight_oz",   "cg_in", "period_s",
                                                                    "moi_oz_in2", "ball_g",      "z_in",  "v_in_mph",
                                                                    "v_out_mph",  "v_swing_mph", "besr",  "bbcor"};

std::optional<metrics::UncertainValue> in_unit(const std::optional<metrics::UncertainValue>& value, double unit) {
  return value ? std::optional(*value / unit) : std::nullopt;
}

Json uncertainty_of(const metrics::UncertainValue& value) {
  Json from = Json::object(), without = Json::array();
  for (std::size_t i = 0; i < metrics::kReadings; ++i) {
    const double part = value.part(static_cast<metrics::Reading>(i));
    if (std::abs(part) > kRoundingOfParts * std::abs(value.value())) from[kReadingNames.at(i)] = std::abs(part);
    if (value.unknown(static_cast<metrics::Reading>(i))) without.push_back(kReadingNames.at(i));
  }
  const double std = std_without_rounding(value);
  return {{"std", std}, {"from", std::move(from)}, {"without", std::move(without)}};
}

Json recorded_or_null(const std::optional<double>& value, double step) {
  return value ? Json(metrics::round_to_step(*value, step)) : Json();
}

Json profile_json(const BatProfileReadings& p, const metrics::BatMetrics& m) {
  Json json{{"length_in", recorded_or_null(p.length_in, p.steps.length_in)},
            {"weight_oz", recorded_or_null(p.weight_oz, p.steps.weight_oz)},
            {"cg_in", recorded_or_null(p.cg_in, p.steps.cg_in)},
            {"handle_diameter_in", recorded_or_null(p.handle_diameter_in, p.steps.diameter_in)},
            {"ball_g", recorded_or_null(p.ball_g, p.steps.ball_g)},
            {"rings", Json::array()},
            {"drop_class", or_null(m.drop_class)}};
  for (std::size_t i = 0; i < p.diameters_in.size(); ++i)
    json["rings"].push_back(
        {{"z_in", 3 + i}, {"diameter_in", metrics::round_to_step(p.diameters_in[i], p.steps.diameter_in)}});
  return json;
}

// A remark that names the readings whose error is not part of the ±; empty when there are none.
std::string missing_errors_text(const metrics::UncertainValue& value) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < metrics::kReadings; ++i) {
    if (value.unknown(static_cast<metrics::Reading>(i))) names.emplace_back(kReadingNames.at(i));
  }
  if (names.empty()) return "";
  return fmt::format("; {} {}", std_without_rounding(value) > 0 ? "± without" : "no ±: no resolution of",
                     fmt::join(names, ", "));
}

std::string verdict(std::size_t computed, std::size_t all) {
  if (computed == 0) return "no metric follows from these readings\n";
  if (computed == all) return "all metrics follow from these readings\n";
  return fmt::format("{} of {} metrics follow{} from these readings; the others need more\n", computed, all,
                     computed == 1 ? "s" : "");
}

ReportText text_of_metrics(const std::vector<MetricLine>& lines, const metrics::BatMetrics& m,
                           const std::vector<metrics::Warning>& warnings) {
  TextTable table({{"number"}, {"value", TextTable::Align::right}, {"unit"}, {"from"}});
  std::size_t computed = 0;
  for (const MetricLine& line : lines) {
    if (!line.value) continue;
    ++computed;
    table.add({line.title, value_with_std(line.value->value(), std_without_rounding(*line.value)), line.unit,
               line.equation + missing_errors_text(*line.value)});
  }
  ReportText out;
  out += verdict(computed, lines.size());
  if (computed > 0) out += table;
  if (m.drop_class) out += fmt::format("class {}\n", *m.drop_class);
  for (const metrics::Warning& warning : warnings) {
    if (warning.severity == warnings::Severity::reject) {
      out.warn({warning.message, warning.options});
    } else {
      out.say({"note: " + warning.message, warning.options});
    }
  }
  return out;
}

}  // namespace

std::vector<MetricLine> metric_lines(const metrics::BatReadings& r, const metrics::BatMetrics& m) {
  const bool speeds = r.in_mps && r.out_mps;
  const auto by = [](bool given, const char* equation) { return std::string(given ? "as given" : equation); };
  const double mph = kMilePerHour_mps;
  return {{"drop", "", "drop", m.drop, "(P1)"},
          {"moi_oz_in2", "oz in²", "moment of inertia", in_unit(m.moi_kgm2, metrics::kOunceInch2_kgm2),
           by(r.moi_kgm2.has_value(), "(P3)")},
          {"besr", "", "BESR", m.besr, speeds ? "(P6)" : by(r.besr.has_value(), "(P9)")},
          {"ncaa_besr", "", "NCAA BESR", m.ncaa_besr, "(P7)"},
          {"bbs_mph", "mph", "batted-ball speed", in_unit(m.bbs_mps, mph), "(P8)"},
          {"bbcor", "", "BBCOR", m.bbcor, by(r.bbcor && !(speeds && m.k), "(P9)")},
          {"v_contact_mph", "mph", "contact speed", in_unit(m.contact_mps, mph), "(P5)"},
          {"v_swing_mph", "mph", "swing speed", in_unit(m.swing_mps, mph), by(r.swing_mps.has_value(), "(P4)")},
          {"k", "", "k", m.k, "(P10)"}};
}

Json metrics_json(const metrics::BatMetrics& metrics, const std::vector<MetricLine>& lines,
                  const std::vector<metrics::Warning>& warnings, const BatProfileReadings& profile) {
  Json json = Json::object(), uncertainty = Json::object(), equation = Json::object();
  for (const MetricLine& line : lines) {
    json[line.key] = line.value ? Json(line.value->value()) : Json();
    if (!line.value) continue;
    uncertainty[line.key] = uncertainty_of(*line.value);
    equation[line.key] = line.equation;
  }
  json["uncertainty"] = std::move(uncertainty);
  json["equation"] = std::move(equation);
  json["profile"] = profile_json(profile, metrics);
  json["warnings"] = Json::array();
  for (const metrics::Warning& warning : warnings) json["warnings"].push_back(warning_json(warning));
  return json;
}

CommandReport metrics_report(const metrics::BatReadings& readings, const BatProfileReadings& profile,
                             const std::optional<BatLabel>& bat) {
  const metrics::BatMetrics metrics = metrics::bat_metrics(readings);
  const auto lines = metric_lines(readings, metrics);
  const auto warnings = metrics::metrics_warnings(readings, metrics);
  Json json{{"schema", "percuss/metrics/1"}, {"version", version()}};
  if (bat) json["bat"] = bat_json(*bat);
  json.update(metrics_json(metrics, lines, warnings, profile));
  CommandReport report;
  report.table = "number,value,std,equation\n";
  for (const MetricLine& line : lines) {
    if (line.value)
      report.table +=
          fmt::format("{},{},{},{}\n", line.key, line.value->value(), std_without_rounding(*line.value), line.equation);
  }
  report.json = indented_text(json) + "\n";
  report.text = text_of_metrics(lines, metrics, warnings);
  return report;
}

}  // namespace percuss::report
