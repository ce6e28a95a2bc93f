#pragma once
#include <string_view>

#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// Whether a text that begins so is a LabVIEW measurement file.
bool is_lvm(std::string_view head);

/// The record in a LabVIEW measurement file (.lvm): separators, units, steps and columns by the file's own tags. Every
/// segment (a header of its own and its data) is a row.
/// errors  InputError with file and line: tags missing or contradictory, a text where a number should be;
/// AmbiguousColumns: nothing says which channel is the force.
Record open_lvm(const FileBytes& file, const ReadOptions& options = {});

}  // namespace percuss::acquire
