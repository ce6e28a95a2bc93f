#include "report/nodes_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "acquire/input_file.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "report/number.hpp"
#include "report/text_table.hpp"
#include "report/version.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

Json mode_json(const Analysis& analysis, const ModeAlongScan& along) {
  const Mode& mode = analysis.modes()[along.mode];
  const Verdict& verdict = analysis.verdicts()[along.mode];
  Json json{{"index", along.mode},
            {"frequency_hz", mode.pole.freq_Hz},
            {"frequency_std_hz", mode.freq_std_Hz},
            {"damping_ratio", mode.pole.damping_ratio},
            {"damping_ratio_std", mode.damping_std},
            {"family", name_of(verdict.family)},
            {"order", verdict.order > 0 ? Json(verdict.order) : Json()},
            {"nodes", Json::array()}};
  for (const Node& node : along.nodes) {
    json["nodes"].push_back({{"position_m", node.position_m},
                             {"std_m", node.std_m},
                             {"position_in", node.position_m / kInch_m},
                             {"std_in", node.std_m / kInch_m},
                             {"degree", node.degree},
                             {"points", node.points}});
  }
  json["minimum_m"] = along.rule_m ? Json(*along.rule_m) : Json();
  json["minimum_in"] = along.rule_m ? Json(*along.rule_m / kInch_m) : Json();
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

std::string heading(const Analysis& analysis, const NodeScan& scan) {
  const Record& record = analysis.record();
  std::string name = one_line(input_name(record.source()), 400);
  if (record.files.size() > 1) name += fmt::format(" and {} more", record.files.size() - 1);
  const ScanPositions& p = scan.positions;
  return fmt::format("{}   {} positions, {:.5g} to {:.5g} in from the barrel's end, {:.4g} in apart\n", name, p.count,
                     p.start_m / kInch_m, p.at_m(p.count - 1) / kInch_m, p.step_m / kInch_m);
}

std::vector<Warning> all_warnings(const Analysis& analysis, const NodeScan& scan) {
  std::vector<Warning> warnings = analysis.warnings();
  warnings.insert(warnings.end(), scan.warnings.begin(), scan.warnings.end());
  return warnings;
}

}  // namespace

std::string nodes_json(const Analysis& analysis, const NodeScan& scan) {
  Json json{{"schema", "percuss/nodes/1"}, {"version", version()}, {"inputs", Json::array()}};
  for (const InputFile& file : analysis.record().files)
    json["inputs"].push_back({{"path", file.path}, {"bytes", file.bytes}});
  json["positions"] = {{"start_m", scan.positions.start_m},
                       {"step_m", scan.positions.step_m},
                       {"end_m", scan.positions.at_m(scan.positions.count - 1)},
                       {"count", scan.positions.count}};
  json["modes"] = Json::array();
  for (const ModeAlongScan& along : scan.modes) json["modes"].push_back(mode_json(analysis, along));
  json["warnings"] = Json::array();
  for (const Warning& warning : all_warnings(analysis, scan))
    json["warnings"].push_back({{"code", warning.code}, {"message", warning.message}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string nodes_text(const Analysis& analysis, const NodeScan& scan, std::size_t width) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"family"},
                   {"frequency", TextTable::Align::right},
                   {"node from the barrel's end", TextTable::Align::right},
                   {"peak's minimum", TextTable::Align::right},
                   {""}});
  for (const ModeAlongScan& along : scan.modes) {
    const Mode& mode = analysis.modes()[along.mode];
    const Verdict& verdict = analysis.verdicts()[along.mode];
    std::vector<std::string> nodes;
    for (const Node& node : along.nodes)
      nodes.push_back(with_deviation(node.position_m / kInch_m, node.std_m / kInch_m) + " in");
    table.add({fmt::format("{}", along.mode),
               verdict.order > 0 ? fmt::format("{} {}", name_of(verdict.family), verdict.order)
                                 : std::string(name_of(verdict.family)),
               with_deviation(mode.pole.freq_Hz, mode.freq_std_Hz) + " Hz", joined(nodes),
               along.rule_m ? fmt::format("{:.3f} in", *along.rule_m / kInch_m) : "–", ""});
  }
  std::string text = heading(analysis, scan) + "\n";
  text += scan.modes.empty() ? "no bending mode stands out of the noise in the band\n" : table.text(width);
  for (const Warning& warning : all_warnings(analysis, scan))
    text += "\n" + wrapped("! " + one_line(warning.message, 4000), width, 2);
  return text.ends_with('\n') ? text : text + "\n";
}

}  // namespace percuss
