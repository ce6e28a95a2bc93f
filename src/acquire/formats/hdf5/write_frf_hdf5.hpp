#pragma once
#include <string>

#include "acquire/record/frf_record.hpp"

namespace percuss::acquire::hdf5 {
class OutputHdf5;
}

namespace percuss::acquire {

/// Writes FRFs as HDF5: /frequency_hz [lines], /frf {r,i} [points, channels, lines], /frf_std and /coherence of the
/// same shape (absent where not known), /point [points]; attributes kind, unit, estimator, averages, decay_per_s (with
/// an exponential window), and angle_deg and position_m of /frf where known. The file is whole or absent, and equal
/// FRFs give equal bytes.
/// errors  InputError: it exists (without `force`) or cannot be written.
void write_frf_record_hdf5(const std::string& path, const FrfRecord& record, FrfKind kind, bool force);

/// The same within a group of a larger file: "bat-1/run-0".
void write_frf_group(hdf5::OutputHdf5& out, const std::string& group, const FrfRecord& record, FrfKind kind);

}  // namespace percuss::acquire
