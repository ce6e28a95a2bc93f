#pragma once
#include <string>

#include "acquire/formats/uff/uff_output.hpp"
#include "acquire/record/frf_record.hpp"

namespace percuss::acquire {

/// Writes FRFs as a universal file: sets 151, 164, 2411 where there is a geometry, and per point and channel functions
/// 58 of type 4 and, where known, 6 (coherence).
void write_frf_record_uff(const std::string& path, const FrfRecord& record, FrfKind kind, bool force,
                          UffData data = UffData::binary);

}  // namespace percuss::acquire
