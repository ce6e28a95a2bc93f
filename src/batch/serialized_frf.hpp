#pragma once
#include <string>
#include <string_view>

#include "frf/frf_record.hpp"

namespace percuss::batch {

/// FRFs as text without a line's end, between the analysis of a record and the file of a whole batch: base64 of their
/// bytes on this kind of machine. Lines, channels with their places, points, estimator and window are kept.
std::string serialize_frfs(const frf::FrfRecord& record);

/// The same back. errors  InputError at `where`: another text.
frf::FrfRecord deserialize_frfs(std::string_view text, const std::string& where);

}  // namespace percuss::batch
