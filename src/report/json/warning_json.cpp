#include "report/json/warning_json.hpp"

#include <nlohmann/json.hpp>

#include "pipeline/warnings/ranking.hpp"

namespace percuss::report {

nlohmann::ordered_json warning_json(const warnings::Warning& warning) {
  nlohmann::ordered_json json{{"code", warning.code},
                              {"severity", name_of(warning.severity.value_or(pipeline::severity_of(warning.code)))},
                              {"message", warning.message}};
  if (!warning.remedy.empty()) json["remedy"] = warning.remedy;
  return json;
}

}  // namespace percuss::report
