#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"

namespace percuss::test {

/// The message of the InputError that `work` throws. Fails the test and returns "" if `work` throws none.
template <class Work>
std::string input_error_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("); "), std::string::npos) << "no place or remedy in: " << message;
    return message;
  }
  ADD_FAILURE() << "no InputError";
  return {};
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
