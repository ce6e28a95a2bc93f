#include "report/nodes_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/units.hpp"
#include "pipeline/warnings/ranking.hpp"
#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/json/warning_json.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"
#include "report/text/warnings_text.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kEmpty = std::numeric_limits<double>::quiet_NaN();  // an empty field of the table

Json mode_json(const pipeline::Analysis& analysis, const pipeline::ModeAlongScan& along) {
  const identify::Mode& mode = analysis.modes()[along.mode];
  const identify::ModeClassification& classification = analysis.classifications()[along.mode];
  Json json{{"index", along.mode},
            {"frequency_hz", mode.pole.freq_Hz},
            {"frequency_std_hz", mode.freq_std_Hz},
            {"damping_ratio", mode.pole.damping_ratio},
            {"damping_ratio_std", mode.damping_std},
            {"family", name_of(classification.type)},
            {"order", classification.order > 0 ? Json(classification.order) : Json()},
            {"nodes", Json::array()}};
  for (const identify::Node& node : along.nodes) {
    json["nodes"].push_back({{"position_m", node.position_m},
                             {"std_m", node.std_m},
                             {"position_in", node.position_m / kInch_m},
                             {"std_in", node.std_m / kInch_m},
                             {"degree", node.degree},
                             {"points", node.points}});
  }
  if (along.no_node) json["no_node"] = identify::name_of(*along.no_node);
  json["minimum_m"] = or_null(along.minimum_m);
  json["minimum_in"] = along.minimum_m ? Json(*along.minimum_m / kInch_m) : Json();
  json["shape"] = Json::array();
  for (std::size_t i = 0; i < along.shape.position_m.size(); ++i) {
    json["shape"].push_back({{"position_m", along.shape.position_m[i]},
                             {"residue", along.shape.amplitude[i]},
                             {"std", along.shape.std[i]},
                             {"peak", along.peak[i]}});
  }
  return json;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all.empty() ? "–" : all;
}

double end_m(const pipeline::ScanPositions& positions) {
  if (positions.listed_m.empty()) return positions.at_m(positions.count - 1);
  return *std::max_element(positions.listed_m.begin(), positions.listed_m.end());
}

std::string heading(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  const std::string name = source_name(analysis.record());
  const pipeline::ScanPositions& p = scan.positions;
  const std::string apart = p.listed_m.empty() ? fmt::format(", {:.4g} in apart", p.step_m / kInch_m) : "";
  return fmt::format("{}   {} positions, {:.5g} to {:.5g} in from the barrel's end{}\n", name, p.count,
                     p.start_m / kInch_m, end_m(p) / kInch_m, apart);
}

std::vector<pipeline::Warning> all_warnings(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  std::vector<pipeline::Warning> warnings = analysis.warnings();
  warnings.insert(warnings.end(), scan.warnings.begin(), scan.warnings.end());
  return pipeline::ranked(std::move(warnings));
}

std::string nodes_json(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  Json json{{"schema", "percuss/nodes/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const acquire::InputFile& file : analysis.record().files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  const pipeline::ScanPositions& positions = scan.positions;
  const bool listed = !positions.listed_m.empty();
  json["positions"] = {{"start_m", positions.start_m},
                       {"step_m", listed ? Json() : Json(positions.step_m)},
                       {"end_m", end_m(positions)},
                       {"count", positions.count}};
  if (listed) json["positions"]["listed_m"] = positions.listed_m;
  json["modes"] = Json::array();
  for (const pipeline::ModeAlongScan& along : scan.modes) json["modes"].push_back(mode_json(analysis, along));
  json["warnings"] = Json::array();
  for (const pipeline::Warning& warning : all_warnings(analysis, scan))
    json["warnings"].push_back(warning_json(warning));
  return indented_text(json) + "\n";
}

std::string_view sentence_of(identify::NoNode reason) {
  switch (reason) {
    case identify::NoNode::few_positions:
      break;
    case identify::NoNode::varies:
      return "the hits of one position differ by more than half the mode's amplitude; such a mode depends on the "
             "direction or the sideways place of the hits";
    case identify::NoNode::uncertain:
      return "fewer than two positions have a certain sign (amplitude above three times its ±)";
    case identify::NoNode::same_sign:
      return "the shape keeps its sign at all positions where the sign is certain (amplitude above three times its ±)";
    case identify::NoNode::wide:
      return "the ± of the crossing is as large as if the node could be anywhere in the scan";
  }
  return "";
}

// A sentence for each reason; the warning few_points stands for the other one.
void add_reasons(ReportText& text, const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  using identify::NoNode;
  for (const NoNode reason : {NoNode::varies, NoNode::uncertain, NoNode::same_sign, NoNode::wide}) {
    std::string modes;
    for (const pipeline::ModeAlongScan& along : scan.modes) {
      if (along.no_node != reason) continue;
      modes += fmt::format("{}{:.5g}", modes.empty() ? "" : ", ", analysis.modes()[along.mode].pole.freq_Hz);
    }
    if (!modes.empty()) text.say(fmt::format("– no node at {} Hz: {}", modes, sentence_of(reason)));
  }
}

ReportText nodes_text(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"family"},
                   {"frequency", TextTable::Align::right},
                   {"node from the barrel's end", TextTable::Align::right},
                   {"lowest peak at", TextTable::Align::right},
                   {""}});
  for (const pipeline::ModeAlongScan& along : scan.modes) {
    const identify::Mode& mode = analysis.modes()[along.mode];
    const identify::ModeClassification& classification = analysis.classifications()[along.mode];
    std::vector<std::string> nodes;
    for (const identify::Node& node : along.nodes)
      nodes.push_back(value_with_std(node.position_m / kInch_m, node.std_m / kInch_m) + " in");
    table.add({fmt::format("{}", along.mode + 1),
               classification.order > 0 ? fmt::format("{} {}", name_of(classification.type), classification.order)
                                        : std::string(name_of(classification.type)),
               value_with_std(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz", joined(nodes),
               along.minimum_m ? fmt::format("{:.3f} in", *along.minimum_m / kInch_m) : "–", ""});
  }
  ReportText text = heading(analysis, scan) + "\n";
  if (scan.modes.empty()) {
    text += "no bending mode rises above the noise in the band\n";
  } else {
    text += table;
    add_reasons(text, analysis, scan);
  }
  const std::vector<pipeline::Warning> warnings = all_warnings(analysis, scan);
  if (!warnings.empty()) text += "\n";
  text += warnings_text(warnings);
  return text;
}

BendingPlot bending_of(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  BendingPlot plot{.ends = "Right: towards the barrel's end.", .from_right = true};
  for (const pipeline::ModeAlongScan& along : scan.modes) {
    double largest = 1e-300;
    for (const double value : along.shape.amplitude) largest = std::max(largest, std::abs(value));
    BendingShape line{.name = mode_name(analysis.classifications()[along.mode], along.mode),
                      .freq_Hz = analysis.modes()[along.mode].pole.freq_Hz,
                      .z_m = along.shape.position_m};
    for (const double value : along.shape.amplitude) line.y.push_back(value / largest);
    for (const identify::Node& node : along.nodes)
      line.nodes.push_back({node.position_m, node.std_m, inches_and_mm(node.position_m, node.std_m)});
    plot.modes.push_back(std::move(line));
  }
  return plot;
}

// Each mode's residues along the scan, 1 at their largest, and its nodes.
LineChart shapes_chart(const BendingPlot& bending) {
  LineChart chart{.title = "Bending along the scan; diamonds: nodes",
                  .x = {.label = "from the barrel's end, in"},
                  .y = {.label = "residue, 1 at its largest"}};
  for (std::size_t m = 0; m < bending.modes.size(); ++m) {
    const BendingShape& line = bending.modes[m];
    ChartCurve curve{
        .name = fmt::format("{}, {:.5g} Hz", line.name, line.freq_Hz), .y = line.y, .marks = true, .style = m};
    for (const double z_m : line.z_m) curve.x.push_back(z_m / kInch_m);
    ChartCurve nodes{.line = false, .mark = ChartMark::open_diamond, .style = m};
    for (const BendingNode& node : line.nodes) {
      nodes.x.push_back(node.z_m / kInch_m);
      nodes.y.push_back(0);
      nodes.labels.push_back(node.text.substr(0, node.text.find(',')));  // in inches, as the axis
    }
    chart.curves.push_back(std::move(curve));
    if (!nodes.x.empty()) chart.curves.push_back(std::move(nodes));
  }
  return chart;
}

// A row per node; a mode without a node has one row.
void add_nodes_table(CommandReport& report, const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  std::vector<NumericColumn> columns{
      {"mode"},   {"order"},      {"frequency_hz"}, {"frequency_std_hz"}, {"damping_ratio"}, {"damping_ratio_std"},
      {"node_m"}, {"node_std_m"}, {"minimum_m"}};
  WordColumn family{"family"};
  for (const pipeline::ModeAlongScan& along : scan.modes) {
    const identify::Mode& mode = analysis.modes()[along.mode];
    const identify::ModeClassification& classification = analysis.classifications()[along.mode];
    for (std::size_t n = 0; n < std::max<std::size_t>(along.nodes.size(), 1); ++n) {
      const bool known = n < along.nodes.size();
      const double order = classification.order > 0 ? static_cast<double>(classification.order) : kEmpty;
      const std::array<double, 9> row{static_cast<double>(along.mode + 1),
                                      order,
                                      mode.pole.freq_Hz,
                                      mode.freq_std_Hz,
                                      mode.pole.damping_ratio,
                                      mode.damping_std,
                                      known ? along.nodes[n].position_m : kEmpty,
                                      known ? along.nodes[n].std_m : kEmpty,
                                      along.minimum_m.value_or(kEmpty)};
      for (std::size_t c = 0; c < row.size(); ++c) columns[c].values.push_back(row[c]);
      family.values.emplace_back(name_of(classification.type));
    }
  }
  report.columns = std::move(columns);
  report.words = {std::move(family)};
}

}  // namespace

CommandReport nodes_report(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan) {
  CommandReport report;
  report.json = nodes_json(analysis, scan);
  report.text = nodes_text(analysis, scan);
  report.bending = bending_of(analysis, scan);
  report.charts = {shapes_chart(report.bending)};
  add_nodes_table(report, analysis, scan);
  return report;
}

}  // namespace percuss::report
