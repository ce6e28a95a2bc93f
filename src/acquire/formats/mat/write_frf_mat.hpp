#pragma once
#include <string>

#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {

/// Writes FRFs as MAT (level 5): variables of the same names as the data sets and attributes of write_frf_record_hdf5.
/// errors  InputError: as MatOutput.
void write_frf_record_mat(const std::string& path, const FrfRecord& record, FrfKind kind, bool force);

}  // namespace percuss::acquire
