#include "report/beam_report.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "report/json/frequency_fit.hpp"
#include "report/json/json_document.hpp"
#include "report/json/or_null.hpp"
#include "report/text/number_format.hpp"
#include "report/text/text_table.hpp"
#include "report/text/version.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShapePoints = 201;
constexpr std::size_t kMaxCurves = 7;
constexpr std::array<const char*, 4> kSupports{"torsion", "pinned", "clamped", "free"};

struct ParameterName {
  const char *key, *name, *unit;
};
ParameterName name_of(model::BeamParameter which) {
  switch (which) {
    case model::BeamParameter::stiffness:
      return {"ei_nm2", "EI", "N·m²"};
    case model::BeamParameter::torsion:
      return {"torsion_nmprad", "T", "N·m/rad"};
    default:
      return {"rho_a_kgpm", "ρA", "kg/m"};
  }
}

Json beam_json(const model::UniformBeam& beam) {
  const bool spring = beam.support == model::BeamSupport::torsion;
  return {{"support", support_name(beam.support)},
          {"ei_nm2", beam.stiffness_Nm2},
          {"rho_a_kgpm", beam.mass_per_length_kgpm},
          {"torsion_nmprad", spring ? Json(beam.torsion_Nmprad) : Json()},
          {"length_m", beam.length_m},
          {"gyration_m", beam.gyration_m > 0 ? Json(beam.gyration_m) : Json()},
          {"shear_stiffness_n", beam.shear_stiffness_N > 0 ? Json(beam.shear_stiffness_N) : Json()}};
}

FrequencyFit frequency_fit(const BeamOrigin& origin) {
  if (!origin.fit) return {};
  FrequencyFit out{.parameters = origin.fit->parameters.size(), .chi2 = origin.fit->chi2};
  for (std::size_t i = 0; i < origin.measured.size(); ++i) {
    const model::MeasuredFrequency& one = origin.measured[i];
    out.frequencies.push_back({one.mode, one.freq_Hz, one.std_Hz, origin.fit->model_Hz[i]});
  }
  return out;
}

Json fit_json(const BeamOrigin& origin) {
  if (!origin.fit && !origin.torsion) return {};
  Json parameters = Json::array();
  const auto add = [&](model::BeamParameter which, double value, const std::optional<double>& std) {
    parameters.push_back({{"name", name_of(which).key}, {"value", value}, {"std", or_null(std)}});
  };
  if (origin.torsion) add(model::BeamParameter::torsion, origin.torsion->torsion_Nmprad, origin.torsion->std_Nmprad);
  if (origin.fit) {
    for (const model::FittedParameter& one : origin.fit->parameters) add(one.which, one.value, one.std);
  }
  const FrequencyFit fit = frequency_fit(origin);
  Json json{{"parameters", parameters},
            {"frequencies", frequencies_json(fit)},
            {"at_limit", origin.fit.has_value() && origin.fit->at_limit}};
  add_birge_ratio(fit, json);
  return json;
}

std::string parameter_text(model::BeamParameter which, double value, const std::optional<double>& std) {
  const ParameterName name = name_of(which);
  if (std) return fmt::format("{} = {} {}\n", name.name, value_with_std(value, *std), name.unit);
  return fmt::format("{} = {:.6g} {} (no ±: no more readings than unknowns)\n", name.name, value, name.unit);
}

ReportText fit_text(const BeamOrigin& origin) {
  ReportText text;
  if (origin.torsion) {
    text += "from static readings: " +
            parameter_text(model::BeamParameter::torsion, origin.torsion->torsion_Nmprad, origin.torsion->std_Nmprad);
  }
  if (!origin.fit) return text;
  for (const model::FittedParameter& one : origin.fit->parameters)
    text += "fitted: " + parameter_text(one.which, one.value, one.std);
  const FrequencyFit fit = frequency_fit(origin);
  text += birge_text(fit);
  if (origin.fit->at_limit)
    text += "the fitted spring acts like a pinned or a clamped end: its stiffness is not determined\n";
  text += frequency_table(fit);
  text += "\n";
  return text;
}

TextTable mode_table(const std::vector<model::BeamMode>& modes) {
  TextTable table({{"mode", TextTable::Align::right},
                   {"frequency", TextTable::Align::right},
                   {"λ", TextTable::Align::right},
                   {"nodes, mm from x = 0"}});
  for (std::size_t i = 0; i < modes.size(); ++i) {
    std::vector<std::string> nodes;
    for (const double node_m : model::beam_nodes_m(modes[i])) nodes.push_back(fmt::format("{:.1f}", 1000 * node_m));
    const bool rigid = modes[i].omega_radps == 0;
    table.add({std::to_string(i), rigid ? "0 Hz" : fmt::format("{:.6g} Hz", modes[i].freq_Hz()),
               rigid ? "rigid body" : fmt::format("{:.6f}", modes[i].lambda),
               fmt::format("{}", fmt::join(nodes, " "))});
  }
  return table;
}

std::string heading(const model::UniformBeam& beam) {
  std::string text = fmt::format("{} beam: EI {:.6g} N·m², ρA {:.6g} kg/m, length {:.6g} m",
                                 beam.support == model::BeamSupport::free      ? "free"
                                 : beam.support == model::BeamSupport::torsion ? "torsion spring/free"
                                 : beam.support == model::BeamSupport::pinned  ? "pinned/free"
                                                                               : "clamped/free",
                                 beam.stiffness_Nm2, beam.mass_per_length_kgpm, beam.length_m);
  if (beam.support == model::BeamSupport::torsion) text += fmt::format(", spring {:.6g} N·m/rad", beam.torsion_Nmprad);
  if (beam.is_timoshenko()) text += "; with the stated rotary inertia and shear (Timoshenko)";
  return text + "\n\n";
}

}  // namespace

const char* support_name(model::BeamSupport support) { return kSupports.at(static_cast<std::size_t>(support)); }

std::optional<model::BeamSupport> support_named(const std::string& name) {
  for (std::size_t i = 0; i < kSupports.size(); ++i) {
    if (name == kSupports.at(i)) return static_cast<model::BeamSupport>(i);
  }
  return {};
}

CommandReport beam_report(const model::UniformBeam& beam, const std::vector<model::BeamMode>& modes,
                          const BeamOrigin& origin) {
  Json json{{"schema", "percuss/model-beam/1"}, {"version", version()}, {"beam", beam_json(beam)}};
  for (const char* list : {"frequency_hz", "lambda", "node_m"}) json[list] = Json::array();
  for (const model::BeamMode& mode : modes) {
    json["frequency_hz"].push_back(mode.freq_Hz());
    json["lambda"].push_back(mode.lambda);
    json["node_m"].push_back(model::beam_nodes_m(mode));
  }
  json["fit"] = fit_json(origin);
  CommandReport report;
  report.json = indented_text(json) + "\n";
  report.text = heading(beam) + fit_text(origin);
  report.text += mode_table(modes);
  NumericColumn x{.name = "x_m"};
  x.values.reserve(kShapePoints);
  for (std::size_t i = 0; i < kShapePoints; ++i)
    x.values.push_back(beam.length_m * static_cast<double>(i) / static_cast<double>(kShapePoints - 1));
  report.columns = {x};
  LineChart chart{
      .title = "Mode shapes of a beam", .x = {.label = "along the beam from x = 0, m"}, .y = {.label = "deflection"}};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    NumericColumn shape{.name = fmt::format("mode_{}", i)};
    shape.values.reserve(kShapePoints);
    for (const double x_m : x.values) shape.values.push_back(modes[i].shape(x_m));
    if (i < kMaxCurves)
      chart.curves.push_back({fmt::format("{}: {:.5g} Hz", i, modes[i].freq_Hz()), x.values, shape.values});
    report.columns.push_back(std::move(shape));
  }
  report.charts.push_back(std::move(chart));
  return report;
}

}  // namespace percuss::report
