#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

/// The one of `known` that `typed` was probably meant to be: the fewest letters left out, added, changed or swapped
/// with their neighbour, but not more than one in three; or the only one that begins so. Case and leading dashes do not
/// count.
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& known);

}  // namespace percuss::tools
