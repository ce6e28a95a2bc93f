#include "core/io/json_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

namespace percuss {
inline namespace core {
namespace {

using nlohmann::json;

// The callbacks of json::parse could do the same, but search a whole list again at the end of each object in it.
class JsonValidator : public nlohmann::json_sax<json> {
 public:
  explicit JsonValidator(const JsonText& input) : input_(input) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (keys_.back().insert(name).second) return true;
    throw InputError(fmt::format("key \"{}\" is given twice", one_line(name, 60)), input_.where, "keep one of them");
  }

  bool parse_error(std::size_t byte, const std::string&, const json::exception& problem) override {
    if (dynamic_cast<const json::out_of_range*>(&problem) != nullptr)
      throw InputError("number too large for double precision", input_.where, "give a finite number");
    throw InputError("not JSON", fmt::format("{}, byte {}", input_.where, byte), input_.remedy, input_.options);
  }

 private:
  bool open() {
    if (keys_.size() >= static_cast<std::size_t>(input_.max_depth)) {
      throw InputError(fmt::format("lists or objects nested deeper than {}", input_.max_depth), input_.where,
                       input_.remedy, input_.options);
    }
    keys_.emplace_back();
    return true;
  }
  bool close() {
    keys_.pop_back();
    return true;
  }

  const JsonText& input_;
  std::vector<std::set<std::string>> keys_;  // of each open list and object
};

}  // namespace

void check_json(const JsonText& input) {
  JsonValidator validator(input);
  json::sax_parse(input.text.begin(), input.text.end(), &validator, json::input_format_t::json, true, input.comments);
}

}  // namespace core
}  // namespace percuss
