#pragma once
#include <string>

namespace percuss::test {

/// The text after the first `from` and before the next `to`.
inline std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from) + from.size();
  return text.substr(start, text.find(to, start) - start);
}

/// A word for a shell; it must hold no quotation mark.
inline std::string quoted(const std::string& word) { return "'" + word + "'"; }

}  // namespace percuss::test
