#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace percuss {
inline namespace core {

/// A text to be read as JSON, with its name and the remedy for messages.
struct JsonText {
  std::string_view text;
  std::string where;  // its name
  std::string remedy = "compare it with a valid example";
  std::vector<OptionId> options{};  // of the remedy: {"synth.example"}
  int max_depth = 6;                // of nested lists and objects
  bool comments = false;
};

/// The keys of a document that a reader wants, at any depth; empty: all.
using WantedKeys = std::span<const std::string_view>;

/// Parses a text, in time proportional to its length. Values of other keys than the wanted ones are checked but not
/// kept. The values take at most 48 MiB plus 6.5 times the memory of the text.
/// errors  InputError: not JSON, nested too deep, a key given twice, more than 10000 keys in one object, a number
/// beyond the range of double, values that need more memory
template <class Json>  // nlohmann::json, which headers do not include
Json parse_json(const JsonText& input, WantedKeys wanted = {});

/// The wanted keys of a text without comments; null where parse_json would throw.
template <class Json>
Json json_if_valid(std::string_view text, WantedKeys wanted);

/// Whether a text begins with a JSON object, after blanks and comments that begin with //.
bool looks_like_json(std::string_view text);

/// Whether the lists and objects of a JSON text are nested more than `depth` times, which would take unbounded memory
/// to read. For texts without comments.
bool nests_deeper_than(std::string_view text, int depth);

}  // namespace core
}  // namespace percuss
