#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/bat/structure_fit.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// The frequencies of the elastic modes if the rows of the table were of the other kind: points instead of slices, or
/// slices instead of points.
struct OtherProfileKind {
  model::ProfileKind kind = model::ProfileKind::points;
  std::vector<double> freq_Hz;
};

/// Where the values of a bat or beam with a table of sections come from.
struct StructureOrigin {
  std::optional<model::StructureFit> fit{};
  std::vector<model::MeasuredMode> measured{};  // that the fit used
  std::optional<double> total_mass_kg{};        // from which the density follows
  std::optional<OtherProfileKind> other{};      // where a stretch exceeds kMaxStretchFraction
  std::size_t first_mode = 1;                   // number of the first elastic mode in the output
};

/// The longest stretch between two rows, as a fraction of the length, up to which their kind hardly matters.
inline constexpr double kMaxStretchFraction = 0.02;

/// Adds the members "profile", "material", "support", "added_mass", "fit" and "warnings".
/// freq_Hz  of the elastic modes, for the comparison with `other`
void add_structure_json(const model::BeamStructure& structure, const StructureOrigin& origin,
                        const std::vector<double>& freq_Hz, nlohmann::ordered_json& json);

/// Adds a line about the sections, the support and the density, the fit, and warnings. `from` names x = 0: "the knob".
void add_structure_text(const model::BeamStructure& structure, const StructureOrigin& origin,
                        const std::vector<double>& freq_Hz, const std::string& from, ReportText& text);

}  // namespace percuss::report
