#pragma once
#include <string>
#include <string_view>

#include "acquire/record/frf_record.hpp"

namespace percuss::batch {

/// FRFs as text without a line end, for the rows of a batch: base64 of their bytes in this machine's byte order. Holds
/// lines, channels with their positions, points, estimator and window.
std::string serialize_frfs(const acquire::FrfRecord& record);

/// The FRFs of such a text. errors  InputError at `where`: another text
acquire::FrfRecord deserialize_frfs(std::string_view text, const std::string& where);

}  // namespace percuss::batch
