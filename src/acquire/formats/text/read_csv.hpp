#pragma once
#include <string>

#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// Opens a text file of columns (docs/reference/formats.md) and describes it. Parses only the columns time, hit, point
/// and run; the read functions parse the others. If the time starts again, it also parses the force, to tell captures
/// from blocks of one recording. Without a force, it also parses the columns that the record leaves out, to note one
/// that looks like the hammer's. The text stays in memory during the lifetime of the record and its copies.
/// errors  InputError with file, line and column: no columns of numbers, no force or acceleration among them, no
/// sampling rate, uneven time, fewer than two samples in a row. The read functions throw it for empty cells and for
/// texts that are not finite numbers.
Record open_csv(const FileBytes& bytes, const ReadOptions& options = {});

}  // namespace percuss::acquire
