#pragma once
#include "acquire/formats/uff/uff_contents.hpp"
#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// The time record in a universal file: its functions 58 for which is_time_record holds (docs/reference/formats.md,
/// "UFF"). A row is a force with the responses that belong to it (uff_rows).
/// errors  InputError with file and line: damaged sets, no time records, different lengths within a row, different
/// rates; AmbiguousColumns: no function is recognisable as the force.
Record open_uff(const FileBytes& file, const ReadOptions& options = {});
Record open_uff(const FileBytes& file, UffContents contents, const ReadOptions& options);

/// Whether a function is a time record: real values of type 1, or of type 0 over time.
bool is_time_record(const UffFunction& function);
/// Whether a function is an FRF: type 4, or complex values of type 0 over frequency.
bool is_uff_frf(const UffFunction& function);

}  // namespace percuss::acquire
