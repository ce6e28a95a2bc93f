#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "acquire/hits/finding.hpp"
#include "core/error.hpp"

namespace percuss::pipeline {

/// A warning about a test: its code for programs, a sentence for people, and the options that the sentence is about.
struct Warning {
  std::string code;
  std::string message;
  std::vector<OptionId> options{};
  std::string remedy{};  // what to do; the end of `message`, see with_remedy()
  /// reject: the results it names are wrong until the remedy is applied; warn: they may be off by more than their ±;
  /// info: nothing is wrong. Without a value the code decides, see ranked().
  std::optional<acquire::Severity> severity{};
};

/// The warning with a remedy, which ends its message: "MESSAGE; REMEDY".
inline Warning with_remedy(Warning warning, std::string remedy) {
  warning.message += "; " + remedy;
  warning.remedy = std::move(remedy);
  return warning;
}

/// Bytes of a channel's name that a warning quotes.
inline constexpr std::size_t kMaxNameBytes = 40;

}  // namespace percuss::pipeline
