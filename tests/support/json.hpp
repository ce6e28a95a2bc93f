#pragma once
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string_view>

namespace percuss::test {

/// nlohmann::json::parse, compiled once. Throws its exceptions.
nlohmann::json parse_json(std::string_view text);

/// The same for a text that may hold comments, /* … */ and // ….
nlohmann::json json_ignoring_comments(std::string_view text);

}  // namespace percuss::test

NLOHMANN_JSON_NAMESPACE_BEGIN
/// GoogleTest's printer of a value. Without it, every comparison compiles a printer for nested containers.
void PrintTo(const json& value, std::ostream* out);
NLOHMANN_JSON_NAMESPACE_END
