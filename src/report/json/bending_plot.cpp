#include "report/json/bending_plot.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "report/json/json_document.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

// Five digits exceed the resolution of a plot.
double rounded_for_plot(double value) { return std::stod(fmt::format("{:.5g}", value)); }

Json all_rounded_for_plot(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(rounded_for_plot(value));
  return out;
}

Json line_json(const BendingShape& line) {
  Json json{{"name", line.name},
            {"hz", line.freq_Hz},
            {"z_m", all_rounded_for_plot(line.z_m)},
            {"y", all_rounded_for_plot(line.y)},
            {"nodes", Json::array()}};
  for (const BendingNode& node : line.nodes)
    json["nodes"].push_back({{"z_m", node.z_m}, {"std_m", node.std_m}, {"text", node.text}});
  return json;
}

}  // namespace

std::string bending_plot_json(const BendingPlot& plot) {
  Json json{{"outline", Json::array()}, {"modes", Json::array()}, {"ends", plot.ends}, {"from_right", plot.from_right}};
  for (const auto& [z_m, radius_m] : plot.outline_m)
    json["outline"].push_back({rounded_for_plot(z_m), rounded_for_plot(radius_m)});
  for (const BendingShape& line : plot.modes) json["modes"].push_back(line_json(line));
  return ascii_text(Json{{"bending", std::move(json)}});
}

std::string inches_and_mm(double value_m, double std_m) {
  if (!(std_m > 0)) return fmt::format("{:.2f} in, {:.1f} mm", value_m / kInch_m, 1000 * value_m);
  return fmt::format("{} in, {} mm", value_with_std(value_m / kInch_m, std_m / kInch_m),
                     value_with_std(1000 * value_m, 1000 * std_m));
}

}  // namespace percuss::report
