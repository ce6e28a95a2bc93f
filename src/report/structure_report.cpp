#include "report/structure_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/section/profile_warnings.hpp"
#include "report/beam_report.hpp"
#include "report/json/frequency_fit.hpp"
#include "report/json/or_null.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

struct StructureName {
  const char *key, *name, *unit;
  double per_unit = 1;  // SI value of one `unit`
};
StructureName name_of(model::StructureParameter which) {
  switch (which) {
    case model::StructureParameter::young:
      return {"young_pa", "Young's modulus", "GPa", 1e9};
    case model::StructureParameter::shear:
      return {"shear_pa", "shear modulus × shape factor", "GPa", 1e9};
    case model::StructureParameter::density:
      return {"density_kgpm3", "density", "kg/m³"};
    case model::StructureParameter::torsion:
      return {"torsion_nmprad", "spring", "N·m/rad"};
    default:
      return {"added_mass_kg", "added mass", "kg"};
  }
}

const char* kind_name(model::ProfileKind kind) { return kind == model::ProfileKind::slices ? "slices" : "points"; }

FrequencyFit frequency_fit(const StructureOrigin& origin) {
  FrequencyFit out{.parameters = origin.fit->parameters.size(), .chi2 = origin.fit->chi2};
  for (std::size_t i = 0; i < origin.measured.size(); ++i) {
    const model::MeasuredMode& one = origin.measured[i];
    out.frequencies.push_back({origin.first_mode + one.elastic, one.freq_Hz, one.std_Hz, origin.fit->model_Hz[i]});
  }
  return out;
}

Json structure_fit_json(const StructureOrigin& origin) {
  if (!origin.fit) return {};
  Json parameters = Json::array();
  for (const model::FittedStructureParameter& one : origin.fit->parameters) {
    parameters.push_back({{"name", name_of(one.which).key}, {"value", one.value}, {"std", or_null(one.std)}});
  }
  const FrequencyFit fit = frequency_fit(origin);
  Json json{{"parameters", parameters}, {"frequencies", frequencies_json(fit)}};
  add_birge_ratio(fit, json);
  return json;
}

std::vector<model::ProfileWarning> warnings_of(const model::BeamStructure& structure, const StructureOrigin& origin,
                                               const std::vector<double>& freq_Hz) {
  std::vector<model::ProfileWarning> out;
  if (origin.other) {
    if (auto slices = model::profile_warning(structure.table, freq_Hz, origin.other->freq_Hz, origin.first_mode))
      out.push_back(*std::move(slices));
  }
  if (!structure.slender) {
    if (auto shear = model::shear_warning(structure.table, structure.material)) out.push_back(*std::move(shear));
  }
  return out;
}

std::string support_text(const model::StructureSupport& support, const std::string& from) {
  const std::string place = fmt::format("{:.1f} mm from {}", 1000 * support.at_m, from);
  switch (support.kind) {
    case model::BeamSupport::torsion:
      return fmt::format("on a pin with a spring of {:.6g} N·m/rad, {}", support.torsion_Nmprad, place);
    case model::BeamSupport::pinned:
      return "on a pin " + place;
    case model::BeamSupport::clamped:
      return "clamped " + place;
    default:
      return "free";
  }
}

void add_fit_text(const StructureOrigin& origin, ReportText& text) {
  for (const model::FittedStructureParameter& one : origin.fit->parameters) {
    const StructureName name = name_of(one.which);
    text += one.std ? fmt::format("fitted: {} {} {}\n", name.name,
                                  value_with_std(one.value / name.per_unit, *one.std / name.per_unit), name.unit)
                    : fmt::format("fitted: {} {:.6g} {} (no ±: no more frequencies than unknowns)\n", name.name,
                                  one.value / name.per_unit, name.unit);
  }
  const FrequencyFit fit = frequency_fit(origin);
  text += birge_text(fit);
  text += frequency_table(fit);
}

}  // namespace

void add_structure_json(const model::BeamStructure& structure, const StructureOrigin& origin,
                        const std::vector<double>& freq_Hz, nlohmann::ordered_json& json) {
  const model::SectionTable& table = structure.table;
  json["profile"] = {{"kind", kind_name(table.kind)},
                     {"section", table.round ? "round" : "rectangular"},
                     {"stations", table.stations.size()},
                     {"layers", table.stations.front().layers.size()},
                     {"longest_fraction", table.longest_fraction()},
                     {"other_kind", Json()}};
  if (origin.other) {
    json["profile"]["other_kind"] = {{"kind", kind_name(origin.other->kind)}, {"frequency_hz", origin.other->freq_Hz}};
  }
  json["material"] = {{"density_kgpm3", structure.material.density_kgpm3},
                      {"young_pa", structure.material.young_Pa},
                      {"shear_pa", structure.slender ? Json() : Json(structure.material.shear_Pa)},
                      {"density_from_mass", origin.total_mass_kg.has_value()}};
  const bool held = structure.support.kind != model::BeamSupport::free;
  const bool spring = structure.support.kind == model::BeamSupport::torsion;
  json["support"] = {{"kind", support_name(structure.support.kind)},
                     {"at_m", held ? Json(structure.support.at_m) : Json()},
                     {"torsion_nmprad", spring ? Json(structure.support.torsion_Nmprad) : Json()}};
  json["added_mass"] = Json::array();
  for (const model::AddedMass& one : structure.added)
    json["added_mass"].push_back({{"mass_kg", one.mass_kg}, {"from_m", one.from_m}, {"to_m", one.to_m}});
  json["fit"] = structure_fit_json(origin);
  json["warnings"] = Json::array();
  for (const auto& [warning, value] : warnings_of(structure, origin, freq_Hz)) {
    json["warnings"].push_back({{"code", warning.code},
                                {"severity", name_of(*warning.severity)},
                                {"message", warning.message},
                                {"value", value},
                                {"remedy", warning.remedy}});
  }
}

void add_structure_text(const model::BeamStructure& structure, const StructureOrigin& origin,
                        const std::vector<double>& freq_Hz, const std::string& from, ReportText& text) {
  const model::SectionTable& table = structure.table;
  std::string line = fmt::format("{} {} ({} between the positions), {}", table.stations.size(), kind_name(table.kind),
                                 table.kind == model::ProfileKind::slices ? "constant" : "linear",
                                 support_text(structure.support, from));
  if (origin.total_mass_kg)
    line += fmt::format("; density {:.1f} kg/m³ from the mass", structure.material.density_kgpm3);
  for (const model::AddedMass& one : structure.added) {
    line += fmt::format("; {:.1f} g added at {:.1f} mm", 1000 * one.mass_kg, 1000 * one.from_m);
    if (one.to_m > one.from_m) line += fmt::format(" to {:.1f} mm", 1000 * one.to_m);
  }
  text.say({line, {}});
  if (origin.fit) add_fit_text(origin, text);
  for (const auto& [warning, value] : warnings_of(structure, origin, freq_Hz))
    text.warn({warning.message, warning.options});
}

}  // namespace percuss::report
