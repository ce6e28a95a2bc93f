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

}  // namespace percuss::test
