#include "metrics/study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/io/json_text.hpp"
#include "core/io/parse_number.hpp"
#include "core/io/strict_json.hpp"
#include "metrics/protocol/performance.hpp"
#include "metrics/study/study_batch.hpp"
#include "metrics/study/study_documents.hpp"

namespace percuss::metrics {
namespace {

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

}  // namespace

const char* StudyBat::condition() const {
  if (!broken_in) return "new";
  return material == BarrelMaterial::composite ? "abi" : "used";
}

namespace {

// Computes quantities from the given columns.
void derive_quantities(StudyBat& bat, const std::optional<double>& weight_oz, const std::optional<double>& z_in) {
  const auto at = [&](StudyQuantity q) -> std::optional<double>& { return bat.values.at(static_cast<std::size_t>(q)); };
  if (!at(StudyQuantity::drop) && weight_oz) at(StudyQuantity::drop) = *weight_oz - bat.length_in;  // (P1)
  const auto moi = at(StudyQuantity::moi);
  if (!moi || !z_in) return;
  const double length_m = bat.length_in * kInch_m, z_m = *z_in * kInch_m, moi_kgm2 = *moi * kOunceInch2_kgm2;
  const double k = ball_to_bat_inertia(kBall_kg, length_m, z_m, moi_kgm2);  // (P10)
  auto& besr = at(StudyQuantity::besr);
  auto& bbs = at(StudyQuantity::bbs);
  auto& bbcor = at(StudyQuantity::bbcor);
  if (!besr && bbcor) besr = besr_from_bbcor(*bbcor, k);  // (P9)
  if (!besr) return;
  if (!bbs) bbs = batted_ball_speed_mps(*besr, swing_speed_mps(length_m, z_m, moi_kgm2)) / kMilePerHour_mps;  // (P8)
  if (!bbcor) bbcor = bbcor_of(*besr, k);                                                                     // (P9)
}

// Decimals of a number's text; none for an exponent.
std::optional<int> decimals_of(const std::string& text) {
  if (text.find_first_of("eE") != std::string::npos) return std::nullopt;
  const std::size_t point = text.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

// Of two numbers, the one with more decimals, if the other is the same number rounded; else none.
const std::string* finer_of(const std::string& a, const std::string& b) {
  const ParsedNumber x = parse_number(a, false), y = parse_number(b, false);
  const auto x_decimals = decimals_of(a), y_decimals = decimals_of(b);
  if (x.problem != NumberProblem::none || y.problem != NumberProblem::none || !x_decimals || !y_decimals)
    return nullptr;
  constexpr double kSlack = 1 + 1e-9;
  constexpr double kMaxRounding = 0.01;  // of the value, because half a unit is too much where the text "6" means 6.0
  const double half = std::min(0.5 * std::pow(10.0, -std::min(*x_decimals, *y_decimals)),
                               kMaxRounding * std::max(std::abs(x.value), std::abs(y.value)));
  if (std::abs(x.value - y.value) > half * kSlack) return nullptr;
  return *x_decimals >= *y_decimals ? &a : &b;
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
  using enum StudyQuantity;
  const std::array frequencies{bending1, bending2, hoop1, hoop2};
  bat.without_family =
      p.contains(kWithoutFamily) &&
      std::none_of(frequencies.begin(), frequencies.end(), [&](StudyQuantity q) { return bat.value(q).has_value(); });
  derive_quantities(bat, number_of(p, "weight_oz", bat.id, 1, 200), number_of(p, "z_in", bat.id, 0, 20));
  return bat;
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
    if (added || at->second == value) continue;
    const std::string* const finer = is_text_column(column) ? nullptr : finer_of(at->second, value);
    if (finer != nullptr) {
      at->second = *finer;
    } else {
      throw InputError(fmt::format("two values of {} for bat {}: {} and {}", column, one_line(id, 60),
                                   one_line(at->second, 40), one_line(value, 40)),
                       where, "keep one");
    }
  }
}

// The states of a break-in are listed in their order, also where documents of later states came first.
void StudyRows::order_states(const std::vector<BatProperties>& states) {
  const std::string bat = states.empty() ? "" : text_of(states.front(), "bat");
  const auto is_of_bat = [&](const BatProperties& state) { return text_of(state, "bat") == bat; };
  if (bat.empty() || !std::all_of(states.begin(), states.end(), is_of_bat)) return;  // a list of several bats
  std::vector<std::string> ids;
  for (const BatProperties& state : states) {
    const std::string id = text_of(state, "id");
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  std::size_t next = 0;
  for (std::string& id : order_) {
    if (std::find(ids.begin(), ids.end(), id) != ids.end()) id = ids.at(next++);
  }
}

// A later state of a bat has the bat's own properties, unless it states them.
BatProperties StudyRows::with_inherited(const BatProperties& state) const {
  BatProperties out = state;
  const auto bat = by_id_.find(text_of(state, "bat"));
  if (bat == by_id_.end()) return out;
  for (const char* column : {"maker", "model", "length_in", "material", "program", "moi_oz_in2", "weight_oz", "drop"}) {
    const auto found = bat->second.find(column);
    if (found != bat->second.end()) out.emplace(column, found->second);
  }
  return out;
}

void StudyRows::add(std::string_view text, const std::string& where) {
  if (holds_batch(text)) {
    for (const BatProperties& bat : batch_bats(text, where)) merge(bat, where);
    return;
  }
  if (const auto states = states_in_document(text, where)) {
    for (const BatProperties& bat : *states) merge(bat, where);
    return order_states(*states);
  }
  const auto read_row = [&](StrictObject& row) {
    BatProperties p;
    for (const char* column : kUnusedMetricsColumns) row.has(column);  // marks the column as known
    for (const std::string& column : study_columns()) {
      if (!row.has(column)) continue;
      double number = 0;
      is_text_column(column) ? row.read(column, p[column]) : row.read(column, number);
      if (!is_text_column(column)) p[column] = fmt::format("{}", number);
    }
    merge(p, row.place());
  };
  const JsonText input{.text = text, .where = where, .options = {kStudyExample}};
  const auto read = [&](StrictObject& o) {
    std::string schema = "percuss/study-table/1";
    o.read("schema", schema);
    if (schema != "percuss/study-table/1") {
      o.fail("not a table of bats", "schema",
             "give a table of bats, or a document of analyze, metrics, certify or abi");
    }
    o.need("bats");
    o.read_list("bats", read_row);
  };
  looks_like_json(text) ? read_strict_json(input, read) : read_strict_table(input, "bats", read);
}

std::vector<StudyBat> StudyRows::bats() const {
  if (order_.empty()) throw InputError("no bats", "the tables", "add a row per bat", {"study.example"});
  std::vector<StudyBat> out;
  out.reserve(order_.size());
  for (const std::string& id : order_) out.push_back(bat_of(with_inherited(by_id_.at(id))));
  return out;
}

}  // namespace percuss::metrics
