#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "model/section/section_table.hpp"

namespace percuss::tools {

/// How a table of sections is read.
struct SectionTableForm {
  std::string units = "m:m";         // of positions, and of diameters, walls, widths and thicknesses
  std::vector<std::string> unnamed;  // the columns of a table without names
  model::ProfileKind kind = model::ProfileKind::slices;
};

/// Reads the sections along a bat or beam: a line per position. A line of names says what the columns are: position
/// (or end, x, z); diameter, or width and thickness; wall; young, shear and density; and the same with _2, _3 … for
/// further layers, from the outside in, or from the underside up. Throws UsageError for units that do not measure
/// length. Throws InputError with file and line as read_named_number_table, and for positions that do not ascend,
/// dimensions out of range, unknown columns, layers without a thickness and more than 1000 lines.
model::SectionTable read_section_table(const std::string& path, const SectionTableForm& form);

}  // namespace percuss::tools
