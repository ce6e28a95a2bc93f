#pragma once
#include <string_view>

#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// Whether these first bytes are the start of a LabVIEW measurement file.
bool is_lvm(std::string_view head);

/// The record in a LabVIEW measurement file (.lvm). The tags of the file state separators, units, steps and columns.
/// Each segment (a header and its data) is a row.
/// errors  InputError with file and line: tags missing or contradictory, a text in place of a number. AmbiguousColumns:
/// no channel is recognisable as the force.
Record open_lvm(const FileBytes& file, const ReadOptions& options = {});

}  // namespace percuss::acquire
