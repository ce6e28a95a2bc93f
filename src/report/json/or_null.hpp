#pragma once
#include <nlohmann/json.hpp>
#include <optional>

namespace percuss::report {

/// The value in a document; null where there is none.
template <class Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace percuss::report
