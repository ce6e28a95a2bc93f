#include "commands/model/structure_flags.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/option_error.hpp"
#include "commands/model/beam_flags.hpp"
#include "model/bat/bat_modes.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxAddedMasses = 100;
constexpr std::size_t kModesCompared = 5;  // between the profile read as slices and read as points
constexpr const char* kAddedForm = "give KG:AT or KG:FROM:TO, in kg and in m from the knob or from x = 0";

std::vector<model::AddedMass> added_masses(const StructureFlags& flags, double length_m) {
  if (flags.added.size() > kMaxAddedMasses)
    throw OptionError({"add_mass"}, "is given more than 100 times", "give fewer");
  std::vector<model::AddedMass> added;
  added.reserve(flags.added.size());
  for (const std::string& text : flags.added) {
    const std::vector<double> number = parse_colon_list("add_mass", text, 2, 3, kAddedForm, ColonZeros::after_first);
    model::AddedMass one{.mass_kg = number[0], .from_m = number[1], .to_m = number.back()};
    if (!(one.to_m >= one.from_m && one.to_m <= length_m * (1 + 1e-9)))
      throw OptionError::wrong_value("add_mass", text, kAddedForm, "the mass is not on the bat or beam");
    one.to_m = std::min(one.to_m, length_m);
    one.from_m = std::min(one.from_m, length_m);
    added.push_back(one);
  }
  return added;
}

}  // namespace

void add_structure_flags(Command& command, StructureFlags& flags, const char* kind, bool required) {
  flags.kind = kind;
  Option profile = command.value(
      "--profile", flags.profile,
      "Read the sections from this file: a position and a diameter, or width and thickness, in each line; with a line "
      "of names also wall, young, shear, density, and wall_2, young_2 … of further layers");
  profile.type("FILE");
  if (required) profile.required();
  command.value("--profile-unit", flags.units, "Set the units of the profile's positions and of its dimensions")
      .type("POSITION:SIZE")
      .show_default();
  command
      .value("--profile-kind", flags.kind,
             "Choose what a line means. slices: its section extends back to the position before; points: dimensions "
             "change linearly between positions")
      .one_of({"slices", "points"})
      .show_default();
  command
      .value("--density", flags.density_kgpm3,
             required ? "Set the density, where the profile has none (default: 649)"
                      : "Set the density of the profile's material, where the profile has none")
      .above_zero()
      .type("KG/M3");
  command
      .value("--young", flags.young_Pa,
             required ? "Set Young's modulus along the bat, where the profile has none (default: 1.814e10)"
                      : "Set Young's modulus of the profile's material, where the profile has none")
      .above_zero()
      .type("PA");
  command
      .value("--shear", flags.shear_Pa,
             required ? "Set the shear modulus times the shape factor, where the profile has none (default: 1.05e9)"
                      : "Add shear and rotary inertia (Timoshenko) to a profile, with this shear modulus times the "
                        "shape factor")
      .above_zero()
      .type("PA");
  command
      .value("--total-mass", flags.total_mass_kg,
             "Compute the density from this measured mass, which includes added masses")
      .above_zero()
      .type("KG");
  command
      .repeatable("--add-mass", flags.added,
                  "Add a point mass (a cap), or a mass spread evenly from one position to another (a grip or an "
                  "insert), in kg and m (repeatable)")
      .type("KG:AT|KG:FROM:TO");
}

model::BeamStructure read_structure(const StructureFlags& flags, const std::vector<std::string>& unnamed) {
  if (flags.total_mass_kg && flags.density_kgpm3)
    throw OptionError({"total_mass", "density"}, "both give the density", "omit one");
  const model::ProfileKind kind = flags.kind == "points" ? model::ProfileKind::points : model::ProfileKind::slices;
  model::BeamStructure structure{
      .table = read_section_table(flags.profile, {.units = flags.units, .unnamed = unnamed, .kind = kind}),
      .material = {}};
  model::Material& material = structure.material;
  material.density_kgpm3 = flags.density_kgpm3.value_or(material.density_kgpm3);
  material.young_Pa = flags.young_Pa.value_or(material.young_Pa);
  material.shear_Pa = flags.shear_Pa.value_or(material.shear_Pa);
  structure.added = added_masses(flags, structure.length_m());
  if (flags.total_mass_kg) structure.material.density_kgpm3 = model::density_for_mass(structure, *flags.total_mass_kg);
  return structure;
}

std::optional<report::OtherProfileKind> other_profile_kind(const model::BeamStructure& structure, std::size_t modes,
                                                           double max_element_fraction) {
  if (structure.table.longest_fraction() <= report::kMaxStretchFraction || structure.table.stations.size() < 2)
    return {};
  model::BeamStructure other = structure;
  const bool slices = structure.table.kind == model::ProfileKind::slices;
  // A first position of 0 has no slice.
  if (!slices && other.table.stations.front().at_m == 0) other.table.stations.erase(other.table.stations.begin());
  other.table.kind = slices ? model::ProfileKind::points : model::ProfileKind::slices;
  const model::BatModes found =
      model::bat_modes(other, {.modes = std::min(modes, kModesCompared), .max_element_fraction = max_element_fraction});
  return report::OtherProfileKind{.kind = other.table.kind, .freq_Hz = {found.freq_Hz.begin(), found.freq_Hz.end()}};
}

}  // namespace percuss::tools
