#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace percuss::report {

/// The value in a document; null where there is none. The caller includes nlohmann/json.hpp.
template <class Value, class Json = nlohmann::ordered_json>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace percuss::report
