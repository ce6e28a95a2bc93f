#pragma once
#include <gtest/gtest.h>

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

/// The options that the InputError of `work` concerns; fails the test when it throws none.
template <class Work>
std::vector<OptionId> options_of_error(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.options();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

}  // namespace percuss::test
