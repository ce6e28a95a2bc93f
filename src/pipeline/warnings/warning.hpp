#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace percuss::pipeline {

/// A warning about a test: its code for programs, a sentence for people, and the options that the sentence is about.
struct Warning {
  std::string code;
  std::string message;
  std::vector<OptionId> options{};
};

/// Bytes of a channel's name that a warning quotes.
inline constexpr std::size_t kMaxNameBytes = 40;

}  // namespace percuss::pipeline
