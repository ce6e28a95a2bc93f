#pragma once
#include <algorithm>
#include <cstddef>
#include <string>

namespace percuss {
inline namespace core {

/// The ending of a regular noun after its number: "" for 1, else "s".
constexpr const char* plural(std::size_t count) { return count == 1 ? "" : "s"; }

/// "A, B, C and 4 more": the first `max` of `count` names, where `name(i)` returns the i-th as a std::string.
template <class Name>
std::string limited_list(std::size_t count, std::size_t max, Name&& name) {
  std::string list;
  for (std::size_t i = 0; i < std::min(count, max); ++i) list += (i > 0 ? ", " : "") + name(i);
  return count > max ? list + " and " + std::to_string(count - max) + " more" : list;
}

}  // namespace core
}  // namespace percuss
