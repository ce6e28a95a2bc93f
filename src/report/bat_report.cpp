#include "report/bat_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/units.hpp"
#include "report/bat_curve.hpp"
#include "report/json/json_document.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kModesInText = 5;

Json modes_json(const model::BatModes& bat) {
  Json json{{"frequency_hz", Json::array()}, {"node_m", Json::array()}};
  for (Eigen::Index mode = 0; mode < bat.freq_Hz.size(); ++mode) {
    json["frequency_hz"].push_back(bat.freq_Hz[mode]);
    json["node_m"].push_back(model::nodes_of(bat, static_cast<std::size_t>(mode)));
  }
  json["mass_kg"] = bat.inertia.mass_kg;
  json["cm_m"] = bat.inertia.cm_m;
  json["inertia_kgm2"] = bat.inertia.inertia_kgm2;
  json["length_m"] = bat.length_m;
  return json;
}

std::string inertia_text(const model::BatModes& bat) {
  return fmt::format("bat: {:.4f} kg, {:.3f} m long, centre of mass {:.1f} mm from the knob, {:.5f} kg·m² about it\n",
                     bat.inertia.mass_kg, bat.length_m, 1000 * bat.inertia.cm_m, bat.inertia.inertia_kgm2);
}

std::string modes_text(const model::BatModes& bat) {
  std::string text;
  for (std::size_t mode = 0; mode < std::min(kModesInText, static_cast<std::size_t>(bat.freq_Hz.size())); ++mode) {
    const std::vector<double> nodes = model::nodes_of(bat, mode);
    fmt::format_to(std::back_inserter(text), "bending {}: {:.1f} Hz, {}", mode + 1,
                   bat.freq_Hz[static_cast<Eigen::Index>(mode)], nodes.empty() ? "no nodes" : "nodes");
    for (const double z : nodes) fmt::format_to(std::back_inserter(text), " {:.1f}", 1000 * z);
    text += nodes.empty() ? "\n" : " mm from the knob\n";
  }
  return text;
}

std::string curve_text(const model::BatModes& bat, const BatCurve& curve) {
  double most = 0, most_at = 0;
  for (std::size_t i = 0; i < curve.z_m.size(); ++i) {
    const double change = std::abs(curve.exit.values[i] - curve.half.values[i]);
    if (change > most) most = change, most_at = curve.z_m[i];
  }
  return fmt::format(
      "the ball leaves fastest, with {:.2f} m/s, {:.1f} mm from the knob ({:.2f} in from the barrel's end); a rigid "
      "bat: {:.2f} m/s at {:.1f} mm\nmodes: {}; with half of them the exit speed changes by up to {:.3f} m/s (at "
      "{:.0f} mm); higher modes may change it by about as much\n",
      curve.best.y, 1000 * curve.best.x, (bat.length_m - curve.best.x) / kInch_m, curve.best_rigid.y,
      1000 * curve.best_rigid.x, bat.freq_Hz.size(), most, 1000 * most_at);
}

// The deflections replace the table and precede the chart.
Json show_wave(const model::BatModes& bat, const model::BatCollision& collision, const BatWaveRequest& wanted,
               CommandReport& report) {
  const Eigen::MatrixXd wave =
      model::bat_wave(bat, static_cast<std::size_t>(bat.freq_Hz.size()), collision, wanted.z_m, wanted.time_s);
  const std::vector<double> at_m = model::positions_of(bat.beam);
  Json json{{"z_m", wanted.z_m}, {"time_s", wanted.time_s}, {"largest_m", Json::array()}, {"at_m", Json::array()}};
  report.columns = {{"z_m", at_m}};
  LineChart chart{.title = fmt::format("Impact {:.0f} mm from the knob", 1000 * wanted.z_m),
                  .x = {.label = "from the knob, m"},
                  .y = {.label = "deflection, mm"},
                  .curves = {}};
  for (Eigen::Index i = 0; i < wave.cols(); ++i) {
    const double time_s = wanted.time_s[static_cast<std::size_t>(i)];
    const std::vector<double> w_m(wave.col(i).begin(), wave.col(i).end());
    Eigen::Index at = 0;
    wave.col(i).cwiseAbs().maxCoeff(&at);
    json["largest_m"].push_back(wave(at, i));
    json["at_m"].push_back(at_m[static_cast<std::size_t>(at)]);
    std::vector<double> w_mm = w_m;
    for (double& w : w_mm) w *= 1000;
    report.columns.push_back({fmt::format("deflection_m_{:g}_s", time_s), w_m});
    chart.curves.push_back({fmt::format("{:g} ms", 1000 * time_s), at_m, w_mm});
  }
  NumericColumn exit{.name = "exit_speed_mps", .values = {}}, rigid{.name = "rigid_exit_speed_mps", .values = {}},
      mass{.name = "effective_mass_kg", .values = {}};
  const std::vector<model::BatRebound> rebounds =
      model::bat_sweep(bat, static_cast<std::size_t>(bat.freq_Hz.size()), collision, at_m);
  for (std::size_t i = 0; i < at_m.size(); ++i) {
    exit.values.push_back(rebounds[i].exit_speed_mps);
    rigid.values.push_back(model::rigid_exit_speed_mps(bat, collision, at_m[i]));
    mass.values.push_back(effective_mass_kg(bat, at_m[i]));
  }
  report.columns.push_back(std::move(exit));
  report.columns.push_back(std::move(rigid));
  add_participation(rebounds, report.columns);
  report.columns.push_back(std::move(mass));
  report.charts.insert(report.charts.begin(), std::move(chart));
  return json;
}

// Half the size of the section across the bending axis.
double half_size_m(const model::SectionTable& table, const model::SectionStation& station) {
  if (table.round) return station.width_m / 2;
  double height_m = 0;
  for (const model::SectionLayer& layer : station.layers) height_m += layer.thickness_m;
  return height_m / 2;
}

BendingPlot bending_of(const model::BatModes& bat, const model::SectionTable& table) {
  BendingPlot plot{.ends = "Left: the knob."};
  for (std::size_t i = 0; i < table.stations.size(); ++i) {
    const model::SectionStation& station = table.stations[i];
    const double half_m = half_size_m(table, station);
    if (table.kind == model::ProfileKind::slices || i == 0) plot.outline_m.emplace_back(table.start_m(i), half_m);
    plot.outline_m.emplace_back(station.at_m, half_m);
  }
  for (std::size_t m = 0; m < std::min(kModesInText, static_cast<std::size_t>(bat.freq_Hz.size())); ++m) {
    const auto column = static_cast<Eigen::Index>(m);
    BendingShape line{
        .name = fmt::format("bending {}", m + 1), .freq_Hz = bat.freq_Hz[column], .z_m = model::positions_of(bat.beam)};
    for (const double z_m : line.z_m) line.y.push_back(bat.deflection(z_m)[column]);
    double largest = 1e-300;
    for (const double y : line.y) largest = std::max(largest, std::abs(y));
    for (double& y : line.y) y /= largest;
    for (const double z_m : model::nodes_of(bat, m)) line.nodes.push_back({z_m, 0, inches_and_mm(z_m, 0)});
    plot.modes.push_back(std::move(line));
  }
  return plot;
}

}  // namespace

CommandReport bat_report(const model::BatModes& bat, const model::BeamStructure& structure,
                         const model::BatCollision& collision, const std::vector<double>& z_m,
                         const StructureOrigin& origin, const std::optional<BatWaveRequest>& wave) {
  const BatCurve curve = bat_curve(bat, collision, z_m);
  const std::vector<double> freq_Hz(bat.freq_Hz.begin(), bat.freq_Hz.end());
  Json json{{"schema", "percuss/model-bat/1"}, {"version", version()}};
  json.update(modes_json(bat));
  json["best"] = {{"z_m", curve.best.x}, {curve.exit.name, curve.best.y}};
  json["curve"] = bat_curve_json(curve);
  add_structure_json(structure, origin, freq_Hz, json);
  CommandReport report;
  report.charts = {{.title = "Flexible bat",
                    .x = {.label = "impact from the knob, m"},
                    .y = {.label = "exit speed, m/s"},
                    .curves = {{"bending", z_m, curve.exit.values}, {"rigid", z_m, curve.rigid.values}}}};
  report.columns = {{"z_m", z_m}, curve.exit, curve.rigid, curve.half, curve.contact, curve.contacts};
  add_participation(curve.flexible, report.columns);
  report.columns.push_back(curve.mass);
  if (wave) json["wave"] = show_wave(bat, collision, *wave, report);
  report.bending = bending_of(bat, structure.table);
  report.text = inertia_text(bat);
  add_structure_text(structure, origin, freq_Hz, "the knob", report.text);
  report.text += modes_text(bat) + curve_text(bat, curve) + "\n";
  report.text += participation_table(curve, bat.freq_Hz.size());
  report.json = indented_text(json) + "\n";
  return report;
}

}  // namespace percuss::report
