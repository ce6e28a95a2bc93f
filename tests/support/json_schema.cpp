#include "support/json_schema.hpp"

#include <algorithm>
#include <fstream>

namespace percuss::test {
namespace {

using nlohmann::json;
using Lines = std::vector<std::string>;

bool is_of(const json& value, const std::string& type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "null") return value.is_null();
  return type == "array" ? value.is_array() : type == "object" && value.is_object();
}

bool any_type(const json& value, const json& types) {
  if (types.is_string()) return is_of(value, types);
  return std::any_of(types.begin(), types.end(), [&](const json& type) { return is_of(value, type); });
}

std::string member_of(std::string place, const std::string& key) { return place.append(".").append(key); }

void append(Lines& to, const Lines& lines) { to.insert(to.end(), lines.begin(), lines.end()); }

Lines in_properties(const json& value, const json& schema, const std::string& place) {
  Lines out;
  for (const auto& [key, item] : value.items()) {
    if (schema["properties"].contains(key)) {
      append(out, schema_violations(item, schema["properties"][key], member_of(place, key)));
    } else if (!schema.value("additionalProperties", true)) {
      out.push_back(member_of(place, key).append(" is not in the schema"));
    }
  }
  return out;
}

Lines in_items(const json& value, const json& items, const std::string& place) {
  Lines out;
  for (std::size_t i = 0; i < value.size(); ++i) {
    append(out, schema_violations(value[i], items, place + "[" + std::to_string(i) + "]"));
  }
  return out;
}

/// Checks one keyword of a schema; a keyword applies only to values of its kind.
bool holds(const json& value, const std::string& word, const json& limit) {
  const auto any_of = [&](const auto& test) { return std::any_of(limit.begin(), limit.end(), test); };
  const auto all_of = [&](const auto& test) { return std::all_of(limit.begin(), limit.end(), test); };
  if (word == "type") return any_type(value, limit);
  if (word == "const") return value == limit;
  if (word == "enum") return any_of([&](const json& one) { return value == one; });
  if (word == "anyOf") return any_of([&](const json& one) { return schema_violations(value, one).empty(); });
  if (word == "required")
    return !value.is_object() || all_of([&](const json& key) { return value.contains(key.get<std::string>()); });
  if (word == "minItems") return !value.is_array() || value.size() >= limit.get<std::size_t>();
  if (word == "maxItems") return !value.is_array() || value.size() <= limit.get<std::size_t>();
  if (word == "minimum") return !value.is_number() || value.get<double>() >= limit.get<double>();
  if (word == "maximum") return !value.is_number() || value.get<double>() <= limit.get<double>();
  if (word == "exclusiveMinimum") return !value.is_number() || value.get<double>() > limit.get<double>();
  return word == "$schema" || word == "$id" || word == "title" || word == "description";
}

}  // namespace

std::vector<std::string> schema_violations(const json& document, const json& schema, const std::string& place) {
  Lines out;
  for (const auto& [word, limit] : schema.items()) {
    if (word == "properties") {
      if (document.is_object()) append(out, in_properties(document, schema, place));
    } else if (word == "items") {
      if (document.is_array()) append(out, in_items(document, limit, place));
    } else if (word != "additionalProperties" && !holds(document, word, limit)) {
      std::string line = place;
      out.push_back(line.append(" breaks ").append(word).append(" ").append(limit.dump(), 0, 100));
    }
  }
  return out;
}

json schema_named(const std::string& name) {
  std::ifstream file(PERCUSS_SOURCE_DIR "/docs/schema/" + name + ".schema.json");
  return json::parse(file);
}

}  // namespace percuss::test
