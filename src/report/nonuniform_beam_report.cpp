#include "report/nonuniform_beam_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/beam_report.hpp"
#include "report/json/json_document.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kNonuniformPoints = 201;
constexpr std::size_t kMaxNonuniformCurves = 7;

// A mode of the beam, rigid or elastic.
struct NonuniformMode {
  double freq_Hz = 0;
  std::vector<double> node_m, shape;  // shape at the positions of the report
};

// A free beam translates (mode 0, no node) and turns about its centre of mass (mode 1, its node). A beam on a pin turns
// about the pin; a support is no node.
NonuniformMode rigid_mode(const model::BatModes& beam, std::size_t mode, const std::vector<double>& x_m) {
  const bool turns = beam.support.kind != model::BeamSupport::free || mode == 1;
  const bool free = beam.support.kind == model::BeamSupport::free;
  const double axis_m = free ? beam.inertia.cm_m : beam.support.at_m;
  NonuniformMode out;
  if (turns && free) out.node_m = {axis_m};
  for (const double x : x_m) out.shape.push_back(turns ? (x - axis_m) / (beam.length_m - axis_m) : 1);
  return out;
}

std::vector<NonuniformMode> all_modes(const model::BatModes& beam, std::size_t count, const std::vector<double>& x_m) {
  std::vector<NonuniformMode> modes;
  const std::size_t rigid = std::min(count, model::rigid_body_modes(beam.support.kind));
  for (std::size_t mode = 0; mode < rigid; ++mode) modes.push_back(rigid_mode(beam, mode, x_m));
  const std::size_t elastic = std::min(count - rigid, static_cast<std::size_t>(beam.freq_Hz.size()));
  const Eigen::VectorXd tip = beam.deflection(beam.length_m);
  std::vector<Eigen::VectorXd> deflections;  // of all modes, at each position
  deflections.reserve(x_m.size());
  for (const double x : x_m) deflections.push_back(beam.deflection(x));
  for (std::size_t mode = 0; mode < elastic; ++mode) {
    const auto at = static_cast<Eigen::Index>(mode);
    NonuniformMode out{.freq_Hz = beam.freq_Hz[at], .node_m = model::nodes_of(beam, mode), .shape = {}};
    for (const Eigen::VectorXd& all : deflections) out.shape.push_back(all[at] / tip[at]);
    modes.push_back(std::move(out));
  }
  return modes;
}

TextTable nonuniform_table(const std::vector<NonuniformMode>& modes) {
  TextTable table(
      {{"mode", TextTable::Align::right}, {"frequency", TextTable::Align::right}, {"nodes, mm from x = 0"}});
  for (std::size_t i = 0; i < modes.size(); ++i) {
    std::vector<std::string> nodes;
    for (const double node_m : modes[i].node_m) nodes.push_back(fmt::format("{:.1f}", 1000 * node_m));
    table.add({std::to_string(i),
               modes[i].freq_Hz > 0 ? fmt::format("{:.6g} Hz", modes[i].freq_Hz) : "0 Hz, rigid body",
               fmt::format("{}", fmt::join(nodes, " "))});
  }
  return table;
}

}  // namespace

CommandReport nonuniform_beam_report(const model::BeamStructure& beam, const model::BatModes& elastic,
                                     std::size_t modes, const StructureOrigin& origin) {
  NumericColumn x{.name = "x_m", .values = {}};
  for (std::size_t i = 0; i < kNonuniformPoints; ++i)
    x.values.push_back(beam.length_m() * static_cast<double>(i) / static_cast<double>(kNonuniformPoints - 1));
  const std::vector<NonuniformMode> all = all_modes(elastic, modes, x.values);
  const std::vector<double> freq_Hz(elastic.freq_Hz.begin(), elastic.freq_Hz.end());
  const bool spring = beam.support.kind == model::BeamSupport::torsion;
  Json json{{"schema", "percuss/model-beam/1"},
            {"version", version()},
            {"beam",
             {{"support", support_name(beam.support.kind)},
              {"ei_nm2", Json()},
              {"rho_a_kgpm", Json()},
              {"torsion_nmprad", spring ? Json(beam.support.torsion_Nmprad) : Json()},
              {"length_m", beam.length_m()},
              {"gyration_m", Json()},
              {"shear_stiffness_n", Json()},
              {"mass_kg", elastic.inertia.mass_kg},
              {"cm_m", elastic.inertia.cm_m},
              {"inertia_kgm2", elastic.inertia.inertia_kgm2}}}};
  for (const char* list : {"frequency_hz", "lambda", "node_m"}) json[list] = Json::array();
  CommandReport report;
  report.columns = {x};
  LineChart chart{
      .title = "Mode shapes of a beam", .x = {.label = "along the beam from x = 0, m"}, .y = {.label = "deflection"}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    json["frequency_hz"].push_back(all[i].freq_Hz);
    json["lambda"].push_back(Json());
    json["node_m"].push_back(all[i].node_m);
    if (i < kMaxNonuniformCurves)
      chart.curves.push_back({fmt::format("{}: {:.5g} Hz", i, all[i].freq_Hz), x.values, all[i].shape});
    report.columns.push_back({fmt::format("mode_{}", i), all[i].shape});
  }
  add_structure_json(beam, origin, freq_Hz, json);
  report.json = indented_text(json) + "\n";
  report.text = fmt::format("beam: {:.6g} kg, length {:.6g} m, centre of mass {:.1f} mm from x = 0{}\n",
                            elastic.inertia.mass_kg, beam.length_m(), 1000 * elastic.inertia.cm_m,
                            beam.slender ? "" : "; with rotary inertia and shear (Timoshenko)");
  add_structure_text(beam, origin, freq_Hz, "x = 0", report.text);
  report.text += "\n";
  report.text += nonuniform_table(all);
  report.charts.push_back(std::move(chart));
  return report;
}

}  // namespace percuss::report
