#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "commands/model/section_table_file.hpp"
#include "model/bat/beam_structure.hpp"
#include "report/structure_report.hpp"

namespace percuss::tools {

/// The options of a table of sections, and of the masses on it.
struct StructureFlags {
  std::string profile, kind;
  std::string units = "m:m";
  std::optional<double> density_kgpm3, young_Pa, shear_Pa, total_mass_kg;
  std::vector<std::string> added;
};

/// `kind` is the default of --profile-kind. `required`: --profile must be given, as for a bat; help texts then differ.
void add_structure_flags(Command& command, StructureFlags& flags, const char* kind, bool required);

/// Reads the table and the masses. The density follows from the total mass where that is given. Throws UsageError for
/// contradictory options, InputError for the file.
/// unnamed  the columns of a table without names
model::BeamStructure read_structure(const StructureFlags& flags, const std::vector<std::string>& unnamed);

/// The frequencies if the rows are read as the other --profile-kind. Nothing if the rows are close together: the kind
/// then makes little difference.
std::optional<report::OtherProfileKind> other_profile_kind(const model::BeamStructure& structure, std::size_t modes,
                                                           double max_element_fraction);

}  // namespace percuss::tools
