#pragma once
#include <string>

#include "acquire/record/frf_record.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The averaged FRFs of an analysis within its band, as a record of FRFs that can be written
/// (acquire/write_record.hpp).
acquire::FrfRecord frf_record_of(const pipeline::Analysis& analysis);

/// Writes the FRFs in the format of the path's extension, one of acquire::frf_extensions(). The file is written whole
/// or not at all. errors  InputError: the file exists (without `force`) or cannot be written.
void write_frfs(const std::string& path, const acquire::FrfRecord& record, acquire::FrfKind kind, bool force);

void write_frf_csv(const std::string& path, const pipeline::Analysis& analysis, acquire::FrfKind kind, bool force);
std::string frf_csv(const pipeline::Analysis& analysis, acquire::FrfKind kind);
void write_frf_hdf5(const std::string& path, const pipeline::Analysis& analysis, acquire::FrfKind kind, bool force);

}  // namespace percuss::report
