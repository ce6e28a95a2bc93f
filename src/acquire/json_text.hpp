#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace percuss {

/// A text to be read as JSON, and what is said when it is none.
struct JsonText {
  std::string_view text;
  std::string where;   // its name, for messages
  std::string remedy;  // "percuss synth --example prints a valid one"
  int max_depth = 6;   // of lists and objects within each other
  bool comments = false;
};

/// The text's value, in time that grows as the text does. Throws InputError when it is not JSON, nests deeper, gives a
/// key twice, or holds a number beyond double's range.
nlohmann::json parse_json(const JsonText& input);

}  // namespace percuss
