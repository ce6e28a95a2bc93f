#pragma once
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string_view>

namespace percuss::test {

/// nlohmann::json::parse, compiled once; throws what that throws.
nlohmann::json parse_json(std::string_view text);

}  // namespace percuss::test

NLOHMANN_JSON_NAMESPACE_BEGIN
/// How GoogleTest shows a value; without it every comparison compiles a printer of containers within containers.
void PrintTo(const json& value, std::ostream* out);
NLOHMANN_JSON_NAMESPACE_END
