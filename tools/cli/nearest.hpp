#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

/// The name that a mistyped word probably means: the only known name that begins with the word (of two letters or
/// more); otherwise the name that needs the fewest changes, at most one for every three letters of the longer word
/// (rounded to the nearest number). A change omits, adds or replaces a letter, or swaps two neighbours. Case and
/// leading dashes are ignored.
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& known);

}  // namespace percuss::tools
