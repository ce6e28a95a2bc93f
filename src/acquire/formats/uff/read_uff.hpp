#pragma once
#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The record of time in a universal file: its functions 58 of type 1 (docs/reference/formats.md, "UFF"). Each force
/// begins a row, and the functions up to the next force are its channels; or forces and responses are separate groups.
/// errors  InputError with file and line: damaged sets, no records of time, functions of one row with different lengths
/// or rates; AmbiguousColumns: no function is recognisable as the force.
Record open_uff(const FileBytes& file, const ReadOptions& options = {});
Record open_uff(const FileBytes& file, UffContents contents, const ReadOptions& options);

/// Whether a function is a record of time; whether it is an FRF.
bool is_time_record(const UffFunction& function);
bool is_uff_frf(const UffFunction& function);

/// "force", "accel 1", or "12+Z" for a place without a name.
std::string uff_dof_name(const UffDof& place);

/// "data sets 15 (1), 58 (3)", for messages.
std::string uff_set_list(const UffContents& contents);

}  // namespace percuss::acquire
