#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "commands/model/structure_flags.hpp"
#include "core/error.hpp"
#include "model/bat/beam_structure.hpp"
#include "model/beam/beam.hpp"

namespace percuss::tools {

/// The options of the beam, shared by `model beam` and `model impact`.
struct BeamFlags {
  std::string support = "torsion";
  std::optional<double> stiffness_Nm2, mass_per_length_kgpm, torsion_Nmprad;
  std::optional<double> length_m;
  std::vector<std::string> layers;
  StructureFlags structure;
};

void add_beam_flags(Command& command, BeamFlags& flags);

/// The uniform beam of the options; by default the composite cricket bat of model::UniformBeam. Throws UsageError for
/// contradictory options.
model::UniformBeam beam_of(const BeamFlags& flags);

/// The longest element of a beam with a table of sections, as a fraction of its length.
inline constexpr double kBeamElementFraction = 1.0 / 200;

/// The beam of the table of sections; nothing without one. Throws UsageError for options of a uniform beam beside the
/// table, for options of the table without one, and for a missing constant of the material.
std::optional<model::BeamStructure> nonuniform_beam_of(const BeamFlags& flags);

/// Which numbers of a list may be zero.
enum class ColonZeros { none, after_first };

/// Reads "1200:0.5:3e-3": `least` to `most` finite numbers above zero, separated by colons; with after_first, all but
/// the first may be zero. Throws an OptionError that ends in `remedy`.
std::vector<double> parse_colon_list(const OptionId& option, const std::string& text, std::size_t least,
                                     std::size_t most, const char* remedy, ColonZeros zeros = ColonZeros::none);

}  // namespace percuss::tools
