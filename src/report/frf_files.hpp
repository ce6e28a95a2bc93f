#pragma once
#include <string>

#include "acquire/record/frf_record.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::report {

/// The averaged FRFs of an analysis within its band, as a record of FRFs that can be written
/// (acquire/write_record.hpp).
acquire::FrfRecord frf_record_of(const pipeline::Analysis& analysis);

/// These FRFs, converted to `kind`, as the text of a CSV file.
std::string frf_csv(const pipeline::Analysis& analysis, acquire::FrfKind kind);

}  // namespace percuss::report
