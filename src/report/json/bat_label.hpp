#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace percuss::report {

/// The bat under test: its id, by which a study joins documents, and its properties by key.
struct BatLabel {
  std::string id;
  std::map<std::string, std::string> properties;
};

/// {"id": …, "properties": {…}}. Numeric values are written as numbers.
nlohmann::ordered_json bat_json(const BatLabel& bat);

}  // namespace percuss::report
