#pragma once
#include <string>

#include "acquire/formats/uff/uff_output.hpp"
#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {

/// Writes FRFs as a universal file: sets 151 and 164; with a geometry, 2411, 82 (trace lines) and 2412 (faces); for
/// each point and channel a function 58 of type 4 and, if known, one of type 6 (coherence).
void write_frf_record_uff(const std::string& path, const FrfRecord& record, FrfKind kind, bool force,
                          UffData data = UffData::binary);

}  // namespace percuss::acquire
