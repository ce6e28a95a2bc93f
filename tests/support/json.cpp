#include "support/json.hpp"

#include <ostream>

namespace percuss::test {

nlohmann::json parse_json(std::string_view text) { return nlohmann::json::parse(text.begin(), text.end()); }

nlohmann::json json_ignoring_comments(std::string_view text) {
  return nlohmann::json::parse(text.begin(), text.end(), nullptr, true, true);
}

}  // namespace percuss::test

NLOHMANN_JSON_NAMESPACE_BEGIN
void PrintTo(const json& value, std::ostream* out) { *out << value.dump(); }
NLOHMANN_JSON_NAMESPACE_END
