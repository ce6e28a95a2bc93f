#include "metrics/study/study_documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "metrics/study/study_batch.hpp"

namespace percuss::metrics {
namespace {

using Json = nlohmann::json;

// The member of an object; null where it is absent.
const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : none;
}

// Sets the column from `value`, if this is a text or a number. An earlier value stays.
void take(BatProperties& p, const char* column, const Json& value) {
  if (value.is_string()) p.emplace(column, value.get<std::string>());
  if (value.is_number()) p.emplace(column, fmt::format("{}", value.get<double>()));
}

void take_all(BatProperties& p, const Json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys) take(p, key, member(object, key));
}

// The frequencies of order 1 and 2 of each family. Of a split mode (two peaks of one family and order), the first.
void take_frequencies(const Json& analysis, BatProperties& p) {
  const Json& modes = member(analysis, "modes");
  if (!modes.is_array()) return;
  const auto has_order = [](const Json& mode) { return member(mode, "order").is_number_integer(); };
  if (!modes.empty() && std::none_of(modes.begin(), modes.end(), has_order)) p.emplace(kWithoutFamily, "");
  for (const Json& mode : modes) {
    const Json &family = member(mode, "family"), &order = member(mode, "order"), &freq = member(mode, "frequency_hz");
    if (!family.is_string() || !order.is_number_integer() || !freq.is_number()) continue;
    add_frequency(p, family.get<std::string>(), order.get<std::int64_t>(), freq.get<double>());
  }
}

// The id and the properties of "bat".
BatProperties named_bat(const Json& document, const std::string& where, const char* problem, const char* remedy,
                        const OptionId& option) {
  const Json& bat = member(document, "bat");
  if (!member(bat, "id").is_string()) throw InputError(problem, where, remedy, {option});
  BatProperties p;
  take(p, "id", bat["id"]);
  const Json& properties = member(bat, "properties");
  if (!properties.is_object()) return p;
  for (const auto& [key, value] : properties.items()) {
    const auto& known = study_columns();
    if (std::find(known.begin(), known.end(), key) != known.end()) take(p, key.c_str(), value);
  }
  return p;
}

BatProperties analysed_bat(const Json& document, const std::string& where) {
  if (document.contains("runs"))
    throw InputError("several tests in one document", where, "analyse one file or run at a time");
  BatProperties p = named_bat(document, where, "the analysis does not name its bat",
                              "analyse the record with the id of its bat", "analyze.bat_id");
  take_frequencies(document, p);
  return p;
}

BatProperties bat_of_metrics(const Json& document, const std::string& where) {
  BatProperties p = named_bat(document, where, "the metrics do not name their bat",
                              "compute them with the id of the bat", "metrics.bat_id");
  take_all(p, member(document, "profile"), {"length_in", "weight_oz"});
  take_all(p, document, {"moi_oz_in2", "besr", "bbs_mph", "bbcor"});
  return p;
}

BatProperties certified_bat(const Json& document, const std::string& where) {
  const Json& bat = member(document, "bat");
  if (!member(bat, "id").is_string()) throw InputError("the session does not name its bat", where, "certify it again");
  BatProperties p;
  take_all(p, bat, {"id", "length_in", "moi_oz_in2", "weight_oz", "material", "condition", "program"});
  if (member(document, "verdict") == "in_progress") return p;
  take_all(p, member(document, "performance"), {"besr", "bbs_mph", "bbcor", "z_in"});
  return p;
}

std::vector<BatProperties> broken_in_states(const Json& document, const std::string& where) {
  const Json &bat = member(document, "bat"), &cycles = member(document, "cycles");
  if (!bat.is_string()) throw InputError("the break-in does not name its bat", where, "evaluate its log again");
  BatProperties first{{"id", bat.get<std::string>()}, {"bat", bat.get<std::string>()}};
  take_all(first, document, {"material", "length_in", "moi_oz_in2"});
  std::vector<BatProperties> out{first};
  if (!cycles.is_array()) return out;
  const char* const metric = member(document, "metric") == "bbcor" ? "bbcor" : "besr";
  out.clear();
  for (const Json& cycle : cycles) {
    BatProperties p = first;
    if (!out.empty()) p["condition"] = "abi";
    if (member(cycle, "id").is_string()) p["id"] = cycle["id"].get<std::string>();
    take(p, metric, member(cycle, "value"));
    take(p, "hoop1_hz", member(cycle, "hoop_hz"));
    take(p, "z_in", member(cycle, "z_in"));
    out.push_back(std::move(p));
  }
  if (!out.empty()) {  // all states belong to the bat of the first one
    for (BatProperties& state : out) state["bat"] = out.front()["id"];
  }
  return out;
}

// The keys that a study reads.
std::vector<std::string_view> wanted_keys() {
  std::vector<std::string_view> keys{"schema", "runs",         "properties", "modes",       "family",
                                     "order",  "frequency_hz", "profile",    "performance", "verdict",
                                     "cycles", "hoop_hz",      "value",      "metric",      "bats"};
  keys.insert(keys.end(), study_columns().begin(), study_columns().end());  // with "bat" and "id"
  return keys;
}

}  // namespace

std::optional<std::vector<BatProperties>> states_in_document(std::string_view text, const std::string& where) {
  if (!looks_like_json(text)) return std::nullopt;
  const Json document = json_if_valid<nlohmann::json>(text, wanted_keys());
  const Json& schema = member(document, "schema");
  if (schema == "percuss/analysis/1") return std::vector{analysed_bat(document, where)};
  if (schema == "percuss/certify/1") return std::vector{certified_bat(document, where)};
  if (schema == "percuss/abi/1") return broken_in_states(document, where);
  if (schema != "percuss/metrics/1") return std::nullopt;
  if (!document.contains("bats")) return std::vector{bat_of_metrics(document, where)};
  std::vector<BatProperties> out;
  for (const Json& bat : document["bats"]) out.push_back(bat_of_metrics(bat, where));
  return out;
}

}  // namespace percuss::metrics
