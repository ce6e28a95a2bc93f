#include "core/io/strict_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/io/csv_dialect.hpp"
#include "core/io/json_from_table.hpp"
#include "core/io/json_text.hpp"
#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {

using nlohmann::json;

namespace {

std::string item_place(const StrictSource& source, const std::string& list, std::size_t i) {
  return source.table && list == source.rows ? fmt::format("line {}", source.lines.at(i))
                                             : fmt::format("{}[{}]", list, i);
}

ParsedNumber cell_number(std::string_view cell, bool decimal_comma) {
  const ParsedNumber number = parse_number(cell, false);
  return decimal_comma && number.problem != NumberProblem::none ? parse_number(cell, true) : number;
}

// The value of a cell that is not read as text: a number, a list of numbers, a Boolean; otherwise its text.
json cell_value(const std::string& cell, bool decimal_comma) {
  if (cell == "yes" || cell == "true") return true;
  if (cell == "no" || cell == "false") return false;
  json list = json::array();
  for (const std::string_view part : split_cells(cell, {.delimiter = ' '})) {
    const ParsedNumber number = cell_number(part, decimal_comma);
    if (number.problem != NumberProblem::none) return cell;
    list.push_back(number.value);
  }
  return list.size() == 1 ? list.front() : list;
}

}  // namespace

struct StrictObject::Impl {
  const json& object;
  const StrictSource& source;
  std::string where;  // of the text
  std::string path;   // of the object in it: "modes[2]"; "" for the document
  std::set<std::string> known{};

  Impl(const json& value, const StrictSource& text, std::string name)
      : object(value), source(text), where(text.where), path(std::move(name)) {
    if (object.is_object()) return;
    throw InputError("not an object", path.empty() ? where : where + ", " + path, "give { \"key\": value, … }");
  }
  const json* find(const std::string& key) {
    known.insert(key);
    const auto it = object.find(key);
    return it == object.end() ? nullptr : &*it;
  }
  // As find, for values other than text: the cells of a table are texts and are parsed.
  const json* find_value(const std::string& key, json& scratch) {
    const json* value = find(key);
    if (value == nullptr || !source.table || !value->is_string()) return value;
    scratch = cell_value(value->get<std::string>(), source.decimal_comma);
    return &scratch;
  }
  std::string path_of(const std::string& key) const { return path.empty() ? key : path + "." + key; }
};

namespace {

constexpr std::size_t kMaxInt = 1'000'000;      // of a number of type int
constexpr double kMaxWhole = 9007199254740992;  // 2^53: a double does not hold all larger whole numbers

void append_numbers(const json& value, std::vector<double>& to, const StrictObject& object, const std::string& key) {
  if (value.is_number()) {
    to.push_back(value.get<double>());
  } else if (value.is_array()) {
    for (const json& item : value) append_numbers(item, to, object, key);
  } else {
    object.fail("not a number", key, "give a list of numbers");
  }
}

json json_of(JsonText input) {
  input.comments = true;
  return parse_json<json>(input);
}

}  // namespace

StrictObject::StrictObject(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StrictObject::~StrictObject() = default;

bool StrictObject::has(const std::string& key) { return impl_->find(key) != nullptr; }

void StrictObject::need(const std::string& key) {
  if (!has(key)) fail("missing", key, "add it; " + impl_->source.remedy, impl_->source.options);
}

void StrictObject::read(const std::string& key, double& to) {
  json scratch;
  const json* value = impl_->find_value(key, scratch);
  if (value == nullptr) return;
  if (!value->is_number()) fail("not a number", key, "give a number");
  to = value->get<double>();
}

void StrictObject::read(const std::string& key, std::optional<double>& to) {
  if (has(key)) read(key, to.emplace());
}

void StrictObject::read(const std::string& key, bool& to) {
  json scratch;
  const json* value = impl_->find_value(key, scratch);
  if (value == nullptr) return;
  if (!value->is_boolean()) fail("neither true nor false", key, "give true or false");
  to = value->get<bool>();
}

void StrictObject::read_within(const std::string& key, double low, double high, double& to) {
  read(key, to);
  if (!has(key) || (to >= low && to <= high)) return;
  fail(fmt::format("{:g} is out of range", to), key, fmt::format("give {:g} to {:g}", low, high));
}

void StrictObject::read_within(const std::string& key, double low, double high, std::optional<double>& to) {
  if (has(key)) read_within(key, low, high, to.emplace());
}

void StrictObject::read(const std::string& key, std::size_t& to) {
  json scratch;
  const json* value = impl_->find_value(key, scratch);
  if (value == nullptr) return;
  if (value->is_number_unsigned()) {
    to = value->get<std::size_t>();
    return;
  }
  const double number = value->is_number() ? value->get<double>() : -1;
  if (!(number >= 0 && number <= kMaxWhole && number == std::floor(number))) {
    fail(fmt::format("{} is not a whole number", one_line(value->dump(), 40)), key, "give a whole number");
  }
  to = static_cast<std::size_t>(number);
}

void StrictObject::read(const std::string& key, int& to) {
  auto value = static_cast<std::size_t>(to);
  read(key, value);
  if (value > kMaxInt) fail(fmt::format("{} is out of range", value), key, fmt::format("give at most {}", kMaxInt));
  to = static_cast<int>(value);
}

void StrictObject::read(const std::string& key, std::string& to) {
  const json* value = impl_->find(key);
  if (value == nullptr) return;
  if (!value->is_string()) fail("not text", key, "give it in quotes");
  to = value->get<std::string>();
}

void StrictObject::read(const std::string& key, std::vector<double>& to) {
  json scratch;
  const json* value = impl_->find_value(key, scratch);
  if (value == nullptr) return;
  if (!value->is_array() && !impl_->source.table) fail("not a list", key, "give a list of numbers");
  to.clear();
  append_numbers(*value, to, *this, key);
}

void StrictObject::read(const std::string& key, std::vector<std::string>& to) {
  const json* value = impl_->find(key);
  if (value == nullptr) return;
  const auto is_text = [](const json& item) { return item.is_string(); };
  if (!value->is_array() || !std::all_of(value->begin(), value->end(), is_text))
    fail("not a list of text", key, R"(give [ "…", … ])");
  to = value->get<std::vector<std::string>>();
}

void StrictObject::read_part(const std::string& key, const Reader& read) {
  const json* part = impl_->find(key);
  if (part == nullptr) return;
  StrictObject object(std::make_unique<Impl>(*part, impl_->source, impl_->path_of(key)));
  read(object);
  object.finish();
}

void StrictObject::read_list(const std::string& key, const Reader& read) {
  const json* list = impl_->find(key);
  if (list == nullptr) return;
  if (list->is_object()) return read_part(key, read);
  if (!list->is_array()) fail("not a list", key, "give [ { … }, … ]");
  for (std::size_t i = 0; i < list->size(); ++i) {
    StrictObject object(
        std::make_unique<Impl>((*list)[i], impl_->source, item_place(impl_->source, impl_->path_of(key), i)));
    read(object);
    object.finish();
  }
}

void StrictObject::finish() const {
  for (const auto& [key, value] : impl_->object.items()) {
    if (impl_->known.count(key) == 0) {
      fail("unknown key", one_line(key, 60), fmt::format("use one of: {}", fmt::join(impl_->known, ", ")));
    }
  }
}

void StrictObject::fail(const std::string& problem, const std::string& key, const std::string& remedy,
                        std::vector<OptionId> options) const {
  throw InputError(problem, fmt::format("{}, {}", impl_->where, impl_->path_of(key)), remedy, std::move(options));
}

std::string StrictObject::place() const {
  return impl_->path.empty() ? impl_->where : fmt::format("{}, {}", impl_->where, impl_->path);
}

void read_strict_json(const JsonText& text, const StrictObject::Reader& read) {
  const json document = json_of(text);
  const StrictSource source{.where = text.where, .remedy = text.remedy, .options = text.options};
  StrictObject object(std::make_unique<StrictObject::Impl>(document, source, ""));
  read(object);
  object.finish();
}

void read_strict_table(const JsonText& text, const std::string& rows, const StrictObject::Reader& read) {
  StrictSource source{.where = text.where, .remedy = text.remedy, .options = text.options, .rows = rows};
  const std::string as_json = json_from_table(text, source);
  const json document = json_of({.text = as_json, .where = text.where});
  StrictObject object(std::make_unique<StrictObject::Impl>(document, source, ""));
  read(object);
  object.finish();
}

}  // namespace core
}  // namespace percuss
