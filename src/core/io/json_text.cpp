#include "core/io/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

namespace percuss {
inline namespace core {
namespace {

using nlohmann::json;

constexpr int kMaxDocumentDepth = 16;                       // documents of percuss nest far less
constexpr std::size_t kMaxKeys = 10'000;                    // of one object
constexpr std::size_t kFreeBytes = std::size_t{48} << 20U;  // allowed to the values of a text of any length
constexpr std::size_t kBytesPerTwo = 13;                    // allowed besides, for every two bytes of the text
// The memory charged for values, with their allocations. kItemBytes: an item of a list, whose memory doubles as it
// grows. kContainerBytes: a list, an object or a text. kKeyBytes: a key with its value. A text of more than kLongText
// bytes has an allocation of its own.
constexpr std::size_t kItemBytes = 64, kContainerBytes = 64, kKeyBytes = 96, kAllocationBytes = 16, kLongText = 15;

std::size_t text_bytes(const std::string& text) { return text.size() > kLongText ? text.size() + kAllocationBytes : 0; }

// Checks a text and builds its values. The callbacks of json::parse could do the same, but search a whole list again at
// the end of each object in it.
class JsonBuilder : public nlohmann::json_sax<json> {
 public:
  JsonBuilder(const JsonText& input, WantedKeys wanted)
      : input_(input), wanted_(wanted), free_bytes_(kFreeBytes + kBytesPerTwo * (input.text.size() / 2)) {}

  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override {
    if (keeps_next()) charge(kContainerBytes + text_bytes(value));
    return add(std::move(value));
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    if (level.keys.size() >= kMaxKeys)
      throw InputError(fmt::format("more than {} keys in one object", kMaxKeys), input_.where, "use a list");
    if (!level.keys.insert(name).second)
      throw InputError(fmt::format("key \"{}\" is given twice", one_line(name, 60)), input_.where, "keep one of them");
    level.keeps_next =
        level.value != nullptr && (wanted_.empty() || std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end());
    if (level.keeps_next) charge(kKeyBytes + text_bytes(name));
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const json::exception& problem) override {
    if (dynamic_cast<const json::out_of_range*>(&problem) != nullptr)
      throw InputError("number too large for double precision", input_.where, "give a finite number");
    throw InputError("not JSON", fmt::format("{}, byte {}", input_.where, byte), input_.remedy, input_.options);
  }

 private:
  // An open list or object.
  struct Level {
    json* value;  // null: not kept
    bool keeps_next;
    std::set<std::string> keys{};
  };

  bool keeps_next() const { return levels_.empty() || levels_.back().keeps_next; }

  void charge(std::size_t bytes) {
    if (bytes > free_bytes_) {
      throw InputError("its values need more memory than a document of its size may take", input_.where, input_.remedy,
                       input_.options);
    }
    free_bytes_ -= bytes;
  }

  // The stored value; null when it is not kept.
  json* put(json&& value) {
    if (levels_.empty()) return &(root_ = std::move(value));
    const Level& level = levels_.back();
    if (!level.keeps_next) return nullptr;
    if (level.value->is_object()) return &((*level.value)[key_] = std::move(value));
    charge(kItemBytes);
    level.value->push_back(std::move(value));
    return &level.value->back();
  }

  template <class Value>
  bool add(Value&& value) {
    if (keeps_next()) put(json(std::forward<Value>(value)));
    return true;
  }

  bool open(json&& empty) {
    if (levels_.size() >= static_cast<std::size_t>(input_.max_depth)) {
      throw InputError(fmt::format("lists or objects nested deeper than {}", input_.max_depth), input_.where,
                       input_.remedy, input_.options);
    }
    if (keeps_next()) charge(kContainerBytes);
    json* const value = put(std::move(empty));
    levels_.push_back({.value = value, .keeps_next = value != nullptr});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return true;
  }

  const JsonText& input_;
  WantedKeys wanted_;
  std::size_t free_bytes_;
  json root_;
  std::string key_;
  std::vector<Level> levels_;
};

}  // namespace

template <>
json parse_json<json>(const JsonText& input, WantedKeys wanted) {
  JsonBuilder builder(input, wanted);
  json::sax_parse(input.text.begin(), input.text.end(), &builder, json::input_format_t::json, true, input.comments);
  return builder.take();
}

template <>
json json_if_valid<json>(std::string_view text, WantedKeys wanted) {
  try {
    return parse_json<json>({.text = text, .where = "", .remedy = "", .max_depth = kMaxDocumentDepth}, wanted);
  } catch (const InputError&) {
    return {};
  }
}

bool looks_like_json(std::string_view text) {
  while (!text.empty()) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string_view::npos) return false;
    text.remove_prefix(first);
    if (!text.starts_with("//")) return text.front() == '{';
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
  return false;
}

bool nests_deeper_than(std::string_view text, int depth) {
  int open = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '{' || c == '[')) {
      if (++open > depth) return true;
    } else if (!quoted && (c == '}' || c == ']')) {
      --open;
    }
  }
  return false;
}

}  // namespace core
}  // namespace percuss
