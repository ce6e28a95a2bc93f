#pragma once
#include <string>
#include <vector>

#include "core/error.hpp"

namespace percuss::test {

/// The texts of notes.
inline std::vector<std::string> texts(const std::vector<Message>& notes) {
  std::vector<std::string> out;
  out.reserve(notes.size());
  for (const Message& note : notes) out.push_back(note.text);
  return out;
}

/// The codes of warnings, findings and the like.
template <class Item>
std::vector<std::string> codes_of(const std::vector<Item>& items) {
  std::vector<std::string> out;
  out.reserve(items.size());
  for (const Item& item : items) out.push_back(item.code);
  return out;
}

/// "code: message" of each.
template <class Item>
std::vector<std::string> lines_of_messages(const std::vector<Item>& items) {
  std::vector<std::string> out;
  out.reserve(items.size());
  for (const Item& item : items) out.push_back(item.code + ": " + item.message);
  return out;
}

}  // namespace percuss::test
