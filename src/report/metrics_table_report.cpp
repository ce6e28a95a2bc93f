#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "metrics/protocol/readings_table.hpp"
#include "report/json/json_document.hpp"
#include "report/metrics_report.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Twelve digits are free of the rounding of the conversion to SI units and back.
std::string cell_of(const std::optional<double>& value) { return value ? fmt::format("{:.12g}", *value) : ""; }

std::string value_cell(const MetricLine& line) { return line.value ? cell_of(line.value->value()) : ""; }

std::string std_cell(const MetricLine& line) {
  const double std = line.value ? std_without_rounding(*line.value) : 0;
  return std > 0 ? cell_of(std) : "";
}

std::string table_header() {
  std::string out = "id";
  for (const std::string& column : metrics::copied_columns()) out += "," + column;
  out += ",length_in,weight_oz,z_in";
  const std::vector<MetricLine> lines = metric_lines({}, {});
  for (const MetricLine& line : lines) out += fmt::format(",{}", line.key);
  for (const MetricLine& line : lines) out += fmt::format(",{}_std", line.key);
  return out + "\n";
}

std::string table_row(const NamedMetrics& bat, const std::vector<MetricLine>& lines, CsvFormulas formulas) {
  std::string out = csv_cell(bat.label.id, formulas);
  for (const std::string& column : metrics::copied_columns()) {
    const auto found = bat.label.properties.find(column);
    out += "," + (found == bat.label.properties.end() ? "" : csv_cell(found->second, formulas));
  }
  const auto z_in = bat.readings.z_m ? std::optional(bat.readings.z_m->value() / kInch_m) : std::nullopt;
  out += fmt::format(",{},{},{}", cell_of(bat.profile.length_in), cell_of(bat.profile.weight_oz), cell_of(z_in));
  for (const MetricLine& line : lines) out += "," + value_cell(line);
  for (const MetricLine& line : lines) out += "," + std_cell(line);
  return out + "\n";
}

// Warnings of equal text, with the bats that they concern.
struct SharedWarning {
  metrics::Warning warning;
  std::vector<std::string> ids;
};

void collect(std::vector<SharedWarning>& all, const std::vector<metrics::Warning>& warnings, const std::string& id) {
  for (const metrics::Warning& warning : warnings) {
    const auto known = std::find_if(all.begin(), all.end(), [&](const SharedWarning& one) {
      return one.warning.code == warning.code && one.warning.message == warning.message;
    });
    if (known == all.end()) {
      all.push_back({warning, {id}});
    } else {
      known->ids.push_back(id);
    }
  }
}

void add_warnings(const std::vector<SharedWarning>& all, std::size_t bats, ReportText& out) {
  for (const auto& [warning, ids] : all) {
    const std::string who = ids.size() == bats
                                ? (bats == 1 ? ids[0] : "all bats")
                                : ids[0] + (ids.size() == 1 ? "" : fmt::format(" and {} more", ids.size() - 1));
    if (warning.severity == warnings::Severity::reject) {
      out.warn({who + ": " + warning.message, warning.options});
    } else {
      out.say({"note: " + who + ": " + warning.message, warning.options});
    }
  }
}

// A row per bat, a column per metric that at least one bat has.
TextTable table_of_bats(const std::vector<NamedMetrics>& bats, const std::vector<std::vector<MetricLine>>& lines) {
  std::vector<TextTable::Column> columns{{"bat"}};
  std::vector<std::size_t> shown;
  for (std::size_t m = 0; m < lines.front().size(); ++m) {
    const bool any = std::any_of(lines.begin(), lines.end(), [&](const auto& row) { return row[m].value.has_value(); });
    if (!any) continue;
    const std::string unit = lines.front()[m].unit;
    columns.push_back(
        {std::string(lines.front()[m].title) + (unit.empty() ? "" : ", " + unit), TextTable::Align::right});
    shown.push_back(m);
  }
  TextTable table(columns);
  for (std::size_t b = 0; b < bats.size(); ++b) {
    std::vector<std::string> cells{bats[b].label.id};
    for (const std::size_t m : shown) {
      const auto& value = lines[b][m].value;
      cells.push_back(value ? value_with_std(value->value(), std_without_rounding(*value)) : "");
    }
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

CommandReport metrics_table_report(const std::vector<NamedMetrics>& bats, CsvFormulas formulas) {
  Json json{{"schema", "percuss/metrics/1"}, {"version", version()}, {"bats", Json::array()}};
  CommandReport report;
  report.table = table_header();
  std::vector<SharedWarning> warnings;
  std::vector<std::vector<MetricLine>> all_lines;
  for (const NamedMetrics& bat : bats) {
    const metrics::BatMetrics computed = metrics::bat_metrics(bat.readings);
    const std::vector<MetricLine> lines = metric_lines(bat.readings, computed);
    all_lines.push_back(lines);
    report.table += table_row(bat, lines, formulas);
    Json one{{"bat", bat_json(bat.label)}};
    const std::vector<metrics::Warning> own = metrics::metrics_warnings(bat.readings, computed);
    one.update(metrics_json(computed, lines, own, bat.profile));
    json["bats"].push_back(std::move(one));
    collect(warnings, own, bat.label.id);
  }
  report.json = indented_text(json) + "\n";
  report.text += table_of_bats(bats, all_lines);
  add_warnings(warnings, bats.size(), report.text);
  return report;
}

}  // namespace percuss::report
