#pragma once
#include <string>

#include "acquire/record/record.hpp"
#include "core/io/input_file.hpp"

namespace percuss::acquire {

/// Opens a text file of columns (docs/reference/formats.md) and describes it: layout, channels and rate are known, of
/// the numbers only the columns time, hit, point and run have been parsed. The text stays in memory while the record or
/// a copy of it lives. errors  InputError, one line with file, line and column: no columns of numbers, no force or
/// acceleration among them, no sampling rate, uneven time, fewer than two samples in a row; the read functions throw it
/// for gaps and for texts that are no finite number.
Record open_csv(const FileBytes& bytes, const ReadOptions& options = {});

}  // namespace percuss::acquire
