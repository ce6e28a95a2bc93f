#include "commands/model/beam_flags.hpp"

#include <algorithm>
#include <cmath>

#include "cli/option_error.hpp"
#include "commands/model/colon_numbers.hpp"
#include "core/error.hpp"
#include "model/beam/laminate.hpp"
#include "report/beam_report.hpp"

namespace percuss::tools {
namespace {

constexpr const char* kLayerForm = "give YOUNG:WIDTH:HEIGHT or YOUNG:WIDTH:HEIGHT:DENSITY, in Pa, m, m and kg/m³";

// Sets the stiffness from the layers, and the mass if all layers have a density.
void use_layers(const BeamFlags& flags, model::UniformBeam& beam) {
  if (flags.stiffness_Nm2) throw OptionError({"ei", "layer"}, "both give the stiffness of the beam", "omit one");
  std::vector<model::LaminateLayer> layers;
  layers.reserve(flags.layers.size());
  std::size_t with_density = 0;
  for (const std::string& text : flags.layers) {
    const std::vector<double> number = parse_colon_list("layer", text, 3, 4, kLayerForm);
    layers.push_back({.young_Pa = number[0], .width_m = number[1], .height_m = number[2]});
    if (number.size() == 4) layers.back().density_kgpm3 = number[3], ++with_density;
  }
  if (with_density > 0 && with_density < layers.size()) {
    throw OptionError({"layer"}, "has a density in some layers only", "give it for all layers, or the mass per length",
                      {"rho_a"});
  }
  if (with_density > 0 && flags.mass_per_length_kgpm)
    throw OptionError({"rho_a", "layer"}, "both give the mass of the beam", "omit one");
  const model::LaminateSection section = model::laminate_section(layers);
  beam.stiffness_Nm2 = section.stiffness_Nm2;
  if (with_density > 0) beam.mass_per_length_kgpm = section.mass_per_length_kgpm;
  if (!(section.stiffness_Nm2 > 0 && std::isfinite(section.stiffness_Nm2)))
    throw OptionError({"layer"}, "gives a stiffness that is not a finite number above 0", kLayerForm);
}

// Refuses a table whose material is not complete.
void check_material(const StructureFlags& flags, const model::BeamStructure& beam) {
  const auto require = [&](bool given, std::optional<double> model::SectionLayer::*constant, const char* option,
                           const char* what) {
    const bool complete = std::all_of(beam.table.stations.begin(), beam.table.stations.end(), [&](const auto& station) {
      return std::all_of(station.layers.begin(), station.layers.end(),
                         [&](const model::SectionLayer& layer) { return (layer.*constant).has_value(); });
    });
    if (!given && !complete)
      throw OptionError({option}, std::string("is missing: the profile does not give ") + what, "give it", {"profile"});
  };
  require(flags.young_Pa.has_value(), &model::SectionLayer::young_Pa, "young", "Young's modulus of all layers");
  require(flags.density_kgpm3 || flags.total_mass_kg, &model::SectionLayer::density_kgpm3, "density",
          "the density of all layers");
  if (!beam.slender)
    require(flags.shear_Pa.has_value(), &model::SectionLayer::shear_Pa, "shear", "the shear modulus of all layers");
}

// Without shear moduli the beam is an Euler–Bernoulli beam.
bool has_shear(const model::BeamStructure& beam) {
  const auto& layers = beam.table.stations.front().layers;
  return std::any_of(layers.begin(), layers.end(), [](const auto& layer) { return layer.shear_Pa.has_value(); });
}

}  // namespace

std::optional<model::BeamStructure> nonuniform_beam_of(const BeamFlags& flags) {
  const StructureFlags& table = flags.structure;
  if (table.profile.empty()) {
    const auto refuse = [](const char* option) {
      return OptionError({option}, "needs a profile, which a uniform beam does not have",
                         "give a profile (two lines for equal sections), or omit this", {"profile"});
    };
    if (table.density_kgpm3) throw refuse("density");
    if (table.young_Pa) throw refuse("young");
    if (table.shear_Pa) throw refuse("shear");
    if (table.total_mass_kg) throw refuse("total_mass");
    if (!table.added.empty()) throw refuse("add_mass");
    return {};
  }
  const auto refuse = [](const char* option, const char* problem) {
    return OptionError({option}, problem, "omit one", {"profile"});
  };
  constexpr const char* kInTable = "belongs to a uniform beam, and the profile gives the sections";
  if (flags.stiffness_Nm2) throw refuse("ei", kInTable);
  if (flags.mass_per_length_kgpm) throw refuse("rho_a", kInTable);
  if (!flags.layers.empty()) throw refuse("layer", kInTable);
  if (flags.length_m) throw refuse("length", kInTable);
  const model::UniformBeam support = beam_of(flags);
  model::BeamStructure beam = read_structure(table, {"position", "width", "thickness"});
  beam.slender = !table.shear_Pa && !has_shear(beam);
  check_material(table, beam);
  beam.support = {.kind = support.support, .at_m = 0, .torsion_Nmprad = support.torsion_Nmprad};
  if (beam.support.kind == model::BeamSupport::torsion && support.torsion_Nmprad == 0)
    beam.support.kind = model::BeamSupport::pinned;
  return beam;
}

std::vector<double> parse_colon_list(const OptionId& option, const std::string& text, std::size_t least,
                                     std::size_t most, const char* remedy, ColonZeros zeros) {
  const auto refuse = [&](const char* problem) { return OptionError::wrong_value(option, text, remedy, problem); };
  const auto numbers = numbers_between_colons(text);
  if (!numbers) throw refuse("it is not numbers separated by colons");
  if (numbers->size() > most) throw refuse("it has too many numbers");
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const double number = (*numbers)[i];
    const bool zero_allowed = zeros == ColonZeros::after_first && i > 0;
    if (!(number > 0 || (zero_allowed && number == 0)))
      throw refuse(zero_allowed ? "a number is below zero" : "every number must be above zero");
  }
  if (numbers->size() < least) throw refuse("it has too few numbers");
  return *numbers;
}

void add_beam_flags(Command& command, BeamFlags& flags) {
  command.value("--support", flags.support, "Choose the support at x = 0; the other end is free")
      .one_of({"torsion", "pinned", "clamped", "free"})
      .show_default();
  command.value("--ei", flags.stiffness_Nm2, "Set the bending stiffness EI (default: 4000)").above_zero().type("N*M2");
  command.value("--rho-a", flags.mass_per_length_kgpm, "Set the mass per length (default: 2.24)")
      .above_zero()
      .type("KG/M");
  command.value("--torsion", flags.torsion_Nmprad, "Set the stiffness of the torsion spring at x = 0 (default: 1200)")
      .not_negative()
      .type("N*M/RAD");
  command.value("--length", flags.length_m, "Set the length of the beam (default: 0.57)").above_zero().type("M");
  command
      .repeatable("--layer", flags.layers,
                  "Add a layer of the section, from the underside up, in Pa, m, m and kg/m³ (repeatable); layers "
                  "replace --ei, and layers with a density also --rho-a")
      .type("YOUNG:WIDTH:HEIGHT[:DENSITY]");
  const std::string previous = command.heading("Beam that is not uniform");
  add_structure_flags(command, flags.structure, "points", false);
  command.heading(previous);
}

model::UniformBeam beam_of(const BeamFlags& flags) {
  model::UniformBeam beam;
  beam.support = report::support_named(flags.support).value();
  beam.stiffness_Nm2 = flags.stiffness_Nm2.value_or(beam.stiffness_Nm2);
  beam.mass_per_length_kgpm = flags.mass_per_length_kgpm.value_or(beam.mass_per_length_kgpm);
  beam.torsion_Nmprad = flags.torsion_Nmprad.value_or(beam.torsion_Nmprad);
  beam.length_m = flags.length_m.value_or(beam.length_m);
  if (!flags.layers.empty()) use_layers(flags, beam);
  if (flags.torsion_Nmprad && beam.support != model::BeamSupport::torsion) {
    throw OptionError({"torsion"}, "needs a torsion spring, and the support is " + flags.support, "omit one",
                      {"support"});
  }
  return beam;
}

}  // namespace percuss::tools
