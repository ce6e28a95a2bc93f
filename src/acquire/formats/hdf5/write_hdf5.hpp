#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record in percuss's own HDF5 layout (docs/reference/formats.md). open_hdf5 reads the same record from it,
/// apart from the losses that FileFormat::record_losses names. Memory does not grow with the record. Equal input gives
/// equal bytes. An interrupted writer leaves the old file or none.
/// shapes  every row must have the same number of samples (the layout's arrays are rectangular).
/// units   float64 in N and m/s² (Pa if the first response is a pressure), whatever the record was read from.
/// errors  InputError: the file exists (without `force`) or cannot be written; rows differ in length.
void write_hdf5(const std::string& path, const Record& record, bool force);

}  // namespace percuss::acquire
