#include "support/json_schema.hpp"

#include <gtest/gtest.h>

#include "support/json.hpp"

namespace percuss::test::json_schema_test {

TEST(SchemaViolations, AreSeen) {
  const nlohmann::json schema = test::parse_json(R"({"type": "object", "additionalProperties": false, "required": ["a"],
      "properties": {"a": {"type": "array", "minItems": 1, "items": {"type": "number", "minimum": 2}},
                     "b": {"enum": ["x"]}}})");
  const auto broken = [&](const char* text) { return schema_violations(test::parse_json(text), schema).size(); };
  EXPECT_EQ(broken(R"({"a": [2, 3], "b": "x"})"), 0U);
  EXPECT_EQ(broken(R"({"a": [1, "3"]})"), 2U);
  EXPECT_EQ(broken(R"({"a": []})"), 1U);
  EXPECT_EQ(broken(R"({"b": "y", "c": 1})"), 3U);
  EXPECT_EQ(broken("[]"), 1U);
  EXPECT_EQ(schema_violations(3, test::parse_json(R"({"multipleOf": 2})")).size(), 1U);
}

}  // namespace percuss::test::json_schema_test
