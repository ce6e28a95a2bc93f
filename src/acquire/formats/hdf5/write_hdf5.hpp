#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record in percuss's own HDF5 layout (docs/reference/formats.md), such that open_hdf5 gives the same record.
/// Memory does not grow with the record; equal input gives equal bytes; an interrupted writer leaves the old file or
/// none. shapes  every row must have the same number of samples (the layout's arrays are rectangular). units   float64
/// in N and m/s², whatever the record was read from. errors  InputError when the file exists and `force` is not set,
/// when it cannot be written, when rows differ in length.
void write_hdf5(const std::string& path, const Record& record, bool force);

}  // namespace percuss::acquire
