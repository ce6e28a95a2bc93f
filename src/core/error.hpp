#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "percuss/error.hpp"

namespace percuss::inline core {

/// A sentence for people, and the options that it is about.
struct Message {
  std::string text;
  std::vector<OptionId> options;

  /// "text (--fs, --unit)"; the text alone where no option belongs to it.
  std::string written(OptionWriter write) const;
};

/// The message where memory ran out.
inline constexpr const char* kOutOfMemoryMessage =
    "not enough memory (the whole run); analyse fewer rows or channels at a time";

/// The command line asks for something that percuss does not offer. what() is "problem; remedy".
class UsageError : public std::runtime_error {
 public:
  UsageError(std::string_view problem, std::string_view remedy);
};

/// `text` as it may stand inside a one-line message: control characters shown as '?', cut after `limit` bytes at most,
/// never inside a UTF-8 character, with "...".
std::string one_line(std::string_view text, std::size_t limit = 200);

}  // namespace percuss::inline core
