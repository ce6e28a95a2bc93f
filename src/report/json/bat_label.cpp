#include "report/json/bat_label.hpp"

#include <nlohmann/json.hpp>

#include "core/io/parse_number.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

nlohmann::ordered_json bat_json(const BatLabel& bat) {
  Json json{{"id", bat.id}, {"properties", Json::object()}};
  for (const auto& [key, text] : bat.properties) {
    const ParsedNumber number = parse_number(text, false);
    json["properties"][key] = number.problem == NumberProblem::none ? Json(number.value) : Json(text);
  }
  return json;
}

}  // namespace percuss::report
