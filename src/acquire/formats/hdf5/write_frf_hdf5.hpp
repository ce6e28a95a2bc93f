#pragma once
#include <string>

#include "acquire/formats/uff/uff_output.hpp"
#include "frf/formats/frf_record.hpp"

namespace percuss::acquire::hdf5 {
class OutputHdf5;
}

namespace percuss::frf {

/// FRFs as files of the kinds that open_measurement reads; `kind` says what they become. All are whole or absent, and
/// equal FRFs give equal bytes. Throw InputError when the file exists (without force) or cannot be written.

/// CSV: frequency_hz, then per point and channel re, im, std, coherence (the last two empty where not known). One line
/// of `#` comment states kind, unit and estimator.
std::string frf_record_csv(const FrfRecord& record, FrfKind kind);

/// HDF5: /frequency_hz [lines], /frf {r,i} [points, channels, lines], /frf_std and /coherence alike (absent where not
/// known); attributes kind, unit, estimator, averages.
void write_frf_record_hdf5(const std::string& path, const FrfRecord& record, FrfKind kind, bool force);

/// The same within a group of a file that holds more: "bat-1/run-0".
void write_frf_group(acquire::hdf5::OutputHdf5& out, const std::string& group, const FrfRecord& record, FrfKind kind);

/// MAT (level 5): the same as HDF5 with variables in place of data sets and attributes.
void write_frf_record_mat(const std::string& path, const FrfRecord& record, FrfKind kind, bool force);

/// Universal file: sets 151, 164, 2411 where there is a geometry, and per point and channel functions 58 of type 4 and,
/// where known, 6 (coherence).
void write_frf_record_uff(const std::string& path, const FrfRecord& record, FrfKind kind, bool force,
                          acquire::UffData data = acquire::UffData::binary);

}  // namespace percuss::frf
