#include "synth/strict_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace percuss {
namespace {

using nlohmann::json;

constexpr double kLargestWhole = 9007199254740992;  // 2^53: beyond it a double no longer counts

void append_numbers(const json& value, std::vector<double>& to, const StrictObject& object, const std::string& key) {
  if (value.is_number()) {
    to.push_back(value.get<double>());
  } else if (value.is_array()) {
    for (const json& item : value) append_numbers(item, to, object, key);
  } else {
    object.fail("not a number", key, "give a list of numbers");
  }
}

}  // namespace

json parse_strict_json(std::string_view text, const std::string& where, int max_depth) {
  std::vector<std::set<std::string>> keys;  // by depth, of the objects being read
  const auto watch = [&](int depth, json::parse_event_t event, json& value) {
    using Event = json::parse_event_t;
    if ((event == Event::object_start || event == Event::array_start) && depth >= max_depth) {
      throw InputError(fmt::format("lists or objects nested deeper than {}", max_depth), where,
                       "see percuss synth --example");
    }
    const auto level = static_cast<std::size_t>(depth);
    if (event == Event::object_start) {
      keys.resize(level + 2);
      keys[level + 1].clear();
    }
    if (event == Event::key && !keys[level].insert(value.get<std::string>()).second) {
      throw InputError(fmt::format("key \"{}\" is given twice", one_line(value.get<std::string>(), 60)), where,
                       "leave one of them");
    }
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), watch, true, true);
  } catch (const json::parse_error& e) {
    throw InputError("not JSON", fmt::format("{}, byte {}", where, e.byte),
                     "correct it; percuss synth --example prints a valid spec");
  } catch (const json::exception& e) {
    throw InputError("a number too large to hold", where, "give a finite number");
  }
}

StrictObject::StrictObject(const json& object, std::string where, std::string path)
    : object_(object), where_(std::move(where)), path_(std::move(path)) {
  if (!object_.is_object()) {
    throw InputError("not an object", path_.empty() ? where_ : where_ + ", " + path_, "give { \"key\": value, … }");
  }
}

const json* StrictObject::find(const std::string& key) {
  asked_.insert(key);
  const auto it = object_.find(key);
  return it == object_.end() ? nullptr : &*it;
}

const json& StrictObject::need(const std::string& key) {
  if (const json* value = find(key)) return *value;
  fail("missing", key, "add it; percuss synth --example shows how");
}

void StrictObject::read(const std::string& key, double& to) {
  const json* value = find(key);
  if (value == nullptr) return;
  if (!value->is_number()) fail("not a number", key, "give a number");
  to = value->get<double>();
}

void StrictObject::read(const std::string& key, std::size_t& to) {
  const json* value = find(key);
  if (value == nullptr) return;
  if (value->is_number_unsigned()) {
    to = value->get<std::size_t>();
    return;
  }
  const double number = value->is_number() ? value->get<double>() : -1;
  if (!(number >= 0 && number <= kLargestWhole && number == std::floor(number))) {
    fail(fmt::format("{} is no count", one_line(value->dump(), 40)), key, "give a whole number");
  }
  to = static_cast<std::size_t>(number);
}

void StrictObject::read(const std::string& key, int& to) {
  std::size_t value = static_cast<std::size_t>(to);
  read(key, value);
  if (value > 1000000) fail(fmt::format("{} is out of range", value), key, "give a small whole number");
  to = static_cast<int>(value);
}

void StrictObject::read(const std::string& key, std::string& to) {
  const json* value = find(key);
  if (value == nullptr) return;
  if (!value->is_string()) fail("not a text", key, "give it in quotes");
  to = value->get<std::string>();
}

void StrictObject::read(const std::string& key, std::vector<double>& to) {
  const json* value = find(key);
  if (value == nullptr) return;
  if (!value->is_array()) fail("not a list", key, "give a list of numbers");
  to.clear();
  append_numbers(*value, to, *this, key);
}

void StrictObject::finish() const {
  for (const auto& [key, value] : object_.items()) {
    if (asked_.count(key) == 0) {
      fail("unknown key", one_line(key, 60), fmt::format("known here: {}", fmt::join(asked_, ", ")));
    }
  }
}

void StrictObject::fail(const std::string& problem, const std::string& key, const std::string& remedy) const {
  throw InputError(problem, fmt::format("{}, {}", where_, path_of(key)), remedy);
}

std::string StrictObject::path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

}  // namespace percuss
