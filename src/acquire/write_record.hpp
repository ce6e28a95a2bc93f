#pragma once
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record as the path's extension says: .h5, .hdf5, .csv, .mat, .uff or .unv.
/// errors  InputError: the file exists (without `force`) or cannot be written, or its format cannot hold the record.
void write_record(const std::string& path, const Record& record, bool force);

/// What a file of that extension would lose of the record, one line each: geometry, sensors' places, notes of units.
std::vector<std::string> losses_of(const std::string& path, const Record& record);

/// The extensions that write_record knows.
const std::vector<std::string>& record_extensions();

}  // namespace percuss::acquire
