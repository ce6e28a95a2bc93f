#pragma once
#include <string>
#include <vector>

#include "support/json.hpp"

namespace percuss::test {

/// Where and how `document` breaks `schema`, one line each; empty when it is valid. Knows the part of JSON Schema that
/// docs/schema uses: type, const, enum, anyOf, properties, required, additionalProperties false, items, minItems,
/// maxItems, minimum, maximum, exclusiveMinimum; any other keyword counts as broken, so that nothing is silently
/// unchecked.
std::vector<std::string> schema_violations(const nlohmann::json& document, const nlohmann::json& schema,
                                           const std::string& place = "$");

/// The schema docs/schema/NAME.schema.json.
nlohmann::json schema_named(const std::string& name);

}  // namespace percuss::test
