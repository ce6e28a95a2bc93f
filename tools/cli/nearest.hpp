#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

/// The name that a mistyped word probably means: the known name with the fewest letters omitted, added, changed or
/// swapped with a neighbour, at most one in three; or the only name that begins with the word. Case and leading dashes
/// are ignored.
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& known);

}  // namespace percuss::tools
