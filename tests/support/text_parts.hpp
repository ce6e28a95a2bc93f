#pragma once
#include <gtest/gtest.h>

#include <string>

namespace percuss::test {

/// The text after the first `from` and before the next `to`.
inline std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from) + from.size();
  return text.substr(start, text.find(to, start) - start);
}

/// The text with the first `from`, which it must contain, replaced by `to`.
inline std::string replaced_once(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// A word for a shell; it must hold no quotation mark.
inline std::string quoted(const std::string& word) { return "'" + word + "'"; }

}  // namespace percuss::test
