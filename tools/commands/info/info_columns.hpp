#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "acquire/channels/csv_columns.hpp"

namespace percuss::tools {

/// How percuss info describes a file whose channels only the user can identify: as JSON, and as text for a terminal.
nlohmann::ordered_json columns_json(const std::string& path, const acquire::AmbiguousColumns& seen);
std::string columns_text(const std::string& path, const acquire::AmbiguousColumns& seen, std::size_t width);

}  // namespace percuss::tools
