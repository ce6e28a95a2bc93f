#include "synth/strict_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"

namespace percuss {

using nlohmann::json;

struct StrictObject::Impl {
  const json& object;
  std::string where, path;  // of the text; of the object in it ("modes[2]", "" for the document)
  std::set<std::string> asked{};

  Impl(const json& value, std::string text, std::string name)
      : object(value), where(std::move(text)), path(std::move(name)) {
    if (object.is_object()) return;
    throw InputError("not an object", path.empty() ? where : where + ", " + path, "give { \"key\": value, … }");
  }
  const json* find(const std::string& key) {
    asked.insert(key);
    const auto it = object.find(key);
    return it == object.end() ? nullptr : &*it;
  }
  std::string path_of(const std::string& key) const { return path.empty() ? key : path + "." + key; }
};

namespace {

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

json parsed(std::string_view text, const std::string& where, int max_depth) {
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

}  // namespace

StrictObject::StrictObject(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StrictObject::~StrictObject() = default;

bool StrictObject::has(const std::string& key) { return impl_->find(key) != nullptr; }

void StrictObject::need(const std::string& key) {
  if (!has(key)) fail("missing", key, "add it; percuss synth --example shows how");
}

void StrictObject::read(const std::string& key, double& to) {
  const json* value = impl_->find(key);
  if (value == nullptr) return;
  if (!value->is_number()) fail("not a number", key, "give a number");
  to = value->get<double>();
}

void StrictObject::read(const std::string& key, std::size_t& to) {
  const json* value = impl_->find(key);
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
  auto value = static_cast<std::size_t>(to);
  read(key, value);
  if (value > 1000000) fail(fmt::format("{} is out of range", value), key, "give a small whole number");
  to = static_cast<int>(value);
}

void StrictObject::read(const std::string& key, std::string& to) {
  const json* value = impl_->find(key);
  if (value == nullptr) return;
  if (!value->is_string()) fail("not a text", key, "give it in quotes");
  to = value->get<std::string>();
}

void StrictObject::read(const std::string& key, std::vector<double>& to) {
  const json* value = impl_->find(key);
  if (value == nullptr) return;
  if (!value->is_array()) fail("not a list", key, "give a list of numbers");
  to.clear();
  append_numbers(*value, to, *this, key);
}

void StrictObject::read_part(const std::string& key, const Reader& read) {
  const json* part = impl_->find(key);
  if (part == nullptr) return;
  StrictObject object(std::make_unique<Impl>(*part, impl_->where, impl_->path_of(key)));
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
        std::make_unique<Impl>((*list)[i], impl_->where, fmt::format("{}[{}]", impl_->path_of(key), i)));
    read(object);
    object.finish();
  }
}

void StrictObject::finish() const {
  for (const auto& [key, value] : impl_->object.items()) {
    if (impl_->asked.count(key) == 0) {
      fail("unknown key", one_line(key, 60), fmt::format("known here: {}", fmt::join(impl_->asked, ", ")));
    }
  }
}

void StrictObject::fail(const std::string& problem, const std::string& key, const std::string& remedy) const {
  throw InputError(problem, fmt::format("{}, {}", impl_->where, impl_->path_of(key)), remedy);
}

void read_strict_json(std::string_view text, const std::string& where, int max_depth,
                      const StrictObject::Reader& read) {
  const json document = parsed(text, where, max_depth);
  StrictObject object(std::make_unique<StrictObject::Impl>(document, where, ""));
  read(object);
  object.finish();
}

}  // namespace percuss
