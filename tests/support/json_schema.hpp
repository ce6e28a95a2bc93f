#pragma once
#include <string>
#include <vector>

#include "support/json.hpp"

namespace percuss::test {

/// The violations of `schema` in `document`, one line each; empty if it is valid. Supports the part of JSON Schema that
/// docs/schema uses: type, const, enum, anyOf, properties, required, additionalProperties false, items, minItems,
/// maxItems, minimum, maximum, exclusiveMinimum. $schema, $id, title and description have no effect. Any other keyword
/// is a violation, so that no further keyword is ignored.
std::vector<std::string> schema_violations(const nlohmann::json& document, const nlohmann::json& schema,
                                           const std::string& place = "$");

/// The schema docs/schema/NAME.schema.json.
nlohmann::json schema_named(const std::string& name);

}  // namespace percuss::test
