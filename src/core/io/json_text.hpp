#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss {
inline namespace core {

/// A text to be read as JSON, and what messages say about it.
struct JsonText {
  std::string_view text;
  std::string where;                // its name
  std::string remedy;               // "compare it with a valid example"
  std::vector<OptionId> options{};  // of the remedy: {"synth.example"}
  int max_depth = 6;                // of nested lists and objects
  bool comments = false;
};

/// Checks a text before it is parsed, in time proportional to its length.
/// errors  InputError: not JSON, nested too deep, a key given twice, a number beyond the range of double
void check_json(const JsonText& input);

}  // namespace core
}  // namespace percuss
