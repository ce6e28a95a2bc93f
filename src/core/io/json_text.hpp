#pragma once
#include <string>
#include <string_view>

namespace percuss::inline core {

/// A text to be read as JSON, and what is said when it is none.
struct JsonText {
  std::string_view text;
  std::string where;   // its name, for messages
  std::string remedy;  // "percuss synth --example prints a valid one"
  int max_depth = 6;   // of lists and objects within each other
  bool comments = false;
};

/// Looks a text through before it becomes a value, in time that grows as the text does. errors  InputError: it is not
/// JSON, nests deeper, gives a key twice, or holds a number beyond double's range.
void check_json(const JsonText& input);

}  // namespace percuss::inline core
