#include "metrics/study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/parse_number.hpp"
#include "core/io/strict_json.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/study/study_batch.hpp"

namespace percuss::metrics {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxBats = 2000;
constexpr double kBall_kg = 0.1454;
constexpr const char* kStudyExample = "study.example";

struct QuantityNames {
  const char *column, *axis, *words;
};
constexpr std::array<QuantityNames, kStudyQuantities> kQuantityNames{
    {{"moi_oz_in2", "MOI, oz in²", "MOI"},
     {"drop", "drop, oz", "drop"},
     {"bending1_hz", "first bending frequency, Hz", "the first bending frequency"},
     {"bending2_hz", "second bending frequency, Hz", "the second bending frequency"},
     {"hoop1_hz", "first hoop frequency, Hz", "the first hoop frequency"},
     {"hoop2_hz", "second hoop frequency, Hz", "the second hoop frequency"},
     {"besr", "BESR", "BESR"},
     {"bbs_mph", "batted-ball speed, mph", "batted-ball speed"},
     {"bbcor", "BBCOR", "BBCOR"}}};

bool is_text_column(const std::string& column) {
  return column == "id" || column == "bat" || column == "maker" || column == "model" || column == "material" ||
         column == "condition" || column == "program";
}

std::optional<double> number_of(const BatProperties& p, const std::string& column, const std::string& id, double low,
                                double high) {
  const auto found = p.find(column);
  if (found == p.end()) return std::nullopt;
  const ParsedNumber number = parse_number(found->second, false);
  const bool fits = number.problem == NumberProblem::none && number.value >= low && number.value <= high;
  if (fits) return number.value;
  throw InputError(fmt::format("{} is {}, which is not a possible value", column, one_line(found->second, 40)),
                   "bat " + one_line(id, 60), fmt::format("give {:g} to {:g}", low, high));
}

std::string text_of(const BatProperties& p, const std::string& column) {
  const auto found = p.find(column);
  return found == p.end() ? "" : found->second;
}

BarrelMaterial material_of(const BatProperties& p, const std::string& id) {
  const std::string word = text_of(p, "material");
  if (word == "wood") return BarrelMaterial::wood;
  if (word == "aluminum" || word == "aluminium") return BarrelMaterial::aluminum;
  if (word == "composite") return BarrelMaterial::composite;
  throw InputError(word.empty() ? "no material" : "no such material: " + one_line(word, 40), "bat " + one_line(id, 60),
                   "give the barrel's material: wood, aluminum or composite");
}

bool broken_in(const BatProperties& p, const std::string& id) {
  const std::string word = text_of(p, "condition");
  if (word.empty() || word == "new") return false;
  if (word == "abi" || word == "used") return true;
  throw InputError("no such condition: " + one_line(word, 40), "bat " + one_line(id, 60), "give new, abi or used");
}

// Computes quantities from the given columns.
void derive_quantities(StudyBat& bat, const std::optional<double>& weight_oz, const std::optional<double>& z_in) {
  const auto at = [&](StudyQuantity q) -> std::optional<double>& { return bat.values.at(static_cast<std::size_t>(q)); };
  if (!at(StudyQuantity::drop) && weight_oz) at(StudyQuantity::drop) = *weight_oz - bat.length_in;  // (P1)
  const auto besr = at(StudyQuantity::besr), moi = at(StudyQuantity::moi);
  if (!besr || !moi || !z_in) return;
  const double length_m = bat.length_in * kInch_m, z_m = *z_in * kInch_m, moi_kgm2 = *moi * kOunceInch2_kgm2;
  auto& bbs = at(StudyQuantity::bbs);
  auto& bbcor = at(StudyQuantity::bbcor);
  if (!bbs) bbs = batted_ball_speed_mps(*besr, swing_speed_mps(length_m, z_m, moi_kgm2)) / kMilePerHour_mps;  // (P8)
  if (!bbcor) bbcor = bbcor_of(*besr, ball_to_bat_inertia(kBall_kg, length_m, z_m, moi_kgm2));                // (P9)
}

StudyBat bat_of(const BatProperties& p) {
  StudyBat bat{.id = text_of(p, "id"),
               .bat = text_of(p, "bat"),
               .maker = text_of(p, "maker"),
               .model = text_of(p, "model"),
               .program = text_of(p, "program")};
  const auto length_in = number_of(p, "length_in", bat.id, 20, 50);
  if (!length_in) throw InputError("no length", "bat " + one_line(bat.id, 60), "add length_in");
  bat.length_in = *length_in;
  bat.material = material_of(p, bat.id);
  bat.broken_in = broken_in(p, bat.id);
  for (std::size_t q = 0; q < kStudyQuantities; ++q) {
    const bool drop = static_cast<StudyQuantity>(q) == StudyQuantity::drop;
    bat.values.at(q) = number_of(p, kQuantityNames.at(q).column, bat.id, drop ? -50 : 1e-6, 1e6);
  }
  derive_quantities(bat, number_of(p, "weight_oz", bat.id, 1, 200), number_of(p, "z_in", bat.id, 0, 20));
  return bat;
}

std::string text_of_value(const Json& value) {
  return value.is_string() ? value.get<std::string>() : fmt::format("{}", value.get<double>());
}

// The first and second frequency of each family, without the second modes of close pairs.
void take_frequencies(const Json& analysis, BatProperties& p) {
  const auto modes = analysis.find("modes");
  if (modes == analysis.end() || !modes->is_array()) return;
  for (const Json& mode : *modes) {
    if (!mode.is_object()) continue;
    const auto family = mode.find("family"), order = mode.find("order"), freq = mode.find("frequency_hz");
    if (family == mode.end() || order == mode.end() || freq == mode.end()) continue;
    if (!family->is_string() || !order->is_number_integer() || !freq->is_number()) continue;
    add_frequency(p, family->get<std::string>(), order->get<std::int64_t>(), freq->get<double>());
  }
}

BatProperties properties_in(const Json& analysis, const std::string& where) {
  const auto bat = analysis.find("bat");
  if (bat == analysis.end() || !bat->is_object() || !bat->contains("id") || !(*bat)["id"].is_string()) {
    throw InputError("the analysis does not name its bat", where, "analyse the record with the id of its bat",
                     {"analyze.bat_id"});
  }
  BatProperties p{{"id", (*bat)["id"].get<std::string>()}};
  const auto properties = bat->find("properties");
  if (properties != bat->end() && properties->is_object()) {
    for (const auto& [key, value] : properties->items()) {
      const auto& known = study_columns();
      const bool simple = value.is_string() || value.is_number();
      if (simple && std::find(known.begin(), known.end(), key) != known.end()) p.emplace(key, text_of_value(value));
    }
  }
  take_frequencies(analysis, p);
  return p;
}

// The keys of an analysis that a study reads.
std::vector<std::string_view> wanted_keys() {
  std::vector<std::string_view> keys{"schema", "runs", "properties", "modes", "family", "order", "frequency_hz"};
  keys.insert(keys.end(), study_columns().begin(), study_columns().end());  // with "bat" and "id"
  return keys;
}

}  // namespace

const char* name_of(BarrelMaterial material) {
  if (material == BarrelMaterial::wood) return "wood";
  return material == BarrelMaterial::aluminum ? "aluminum" : "composite";
}

const char* column_of(StudyQuantity q) { return kQuantityNames.at(static_cast<std::size_t>(q)).column; }
const char* axis_of(StudyQuantity q) { return kQuantityNames.at(static_cast<std::size_t>(q)).axis; }
const char* phrase_of(StudyQuantity q) { return kQuantityNames.at(static_cast<std::size_t>(q)).words; }

int StudyBat::length_class() const { return static_cast<int>(std::lround(length_in)); }

const std::vector<std::string>& study_columns() {
  static const std::vector<std::string> columns{"id",          "bat",       "maker",    "model",      "length_in",
                                                "material",    "condition", "program",  "moi_oz_in2", "weight_oz",
                                                "drop",        "besr",      "bbs_mph",  "bbcor",      "bending1_hz",
                                                "bending2_hz", "hoop1_hz",  "hoop2_hz", "z_in"};
  return columns;
}

void StudyRows::merge(const BatProperties& properties, const std::string& where) {
  const std::string id = text_of(properties, "id");
  if (id.empty() || id.size() > 80)
    throw InputError("a bat without an id of 1 to 80 characters", where, "fill the column id");
  auto [known, fresh] = by_id_.try_emplace(id);
  if (fresh) order_.push_back(id);
  if (order_.size() > kMaxBats) throw InputError("more than 2000 bats", where, "split the study");
  for (const auto& [column, value] : properties) {
    const auto [at, added] = known->second.emplace(column, value);
    if (!added && at->second != value) {
      throw InputError(fmt::format("two values of {} for bat {}: {} and {}", column, one_line(id, 60),
                                   one_line(at->second, 40), one_line(value, 40)),
                       where, "keep one");
    }
  }
}

void StudyRows::add(std::string_view text, const std::string& where) {
  if (holds_batch(text)) {
    for (const BatProperties& bat : batch_bats(text, where)) merge(bat, where);
    return;
  }
  if (looks_like_json(text)) {
    const Json document = json_if_valid<nlohmann::json>(text, wanted_keys());
    const auto schema = document.is_object() ? document.find("schema") : document.end();
    if (document.is_object() && schema != document.end() && *schema == "percuss/analysis/1") {
      const auto runs = document.find("runs");
      if (runs != document.end())
        throw InputError("several tests in one document", where, "analyse one file or run at a time");
      return merge(properties_in(document, where), where);
    }
  }
  const auto read_row = [&](StrictObject& row) {
    BatProperties p;
    for (const std::string& column : study_columns()) {
      if (!row.has(column)) continue;
      double number = 0;
      is_text_column(column) ? row.read(column, p[column]) : row.read(column, number);
      if (!is_text_column(column)) p[column] = fmt::format("{}", number);
    }
    merge(p, row.place());
  };
  const StrictText input{.text = text, .where = where, .options = {kStudyExample}};
  const auto read = [&](StrictObject& o) {
    std::string schema = "percuss/study-table/1";
    o.read("schema", schema);
    if (schema != "percuss/study-table/1") o.fail("not a table of bats", "schema", "give a table or analyses");
    o.need("bats");
    o.read_list("bats", read_row);
  };
  looks_like_json(text) ? read_strict_json(input, read) : read_strict_table(input, "bats", read);
}

std::vector<StudyBat> StudyRows::bats() const {
  if (order_.empty()) throw InputError("no bats", "the tables", "add a row per bat", {"study.example"});
  std::vector<StudyBat> out;
  out.reserve(order_.size());
  for (const std::string& id : order_) out.push_back(bat_of(by_id_.at(id)));
  return out;
}

}  // namespace percuss::metrics
