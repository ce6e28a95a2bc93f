#pragma once
#include <string>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Writes a record as a MAT file of level 5: fs, force [hits, samples] (N), accel [hits, channels, samples] (m/s^2, or
/// Pa if the first response is a pressure), force_unit and accel_unit. The other parts of percuss's HDF5 layout follow
/// by the same names, except date, rejected and faults. All hits must have the same number of samples.
/// errors  InputError: as write_hdf5, and arrays of 2 GiB and more.
void write_mat(const std::string& path, const Record& record, bool force);

}  // namespace percuss::acquire
