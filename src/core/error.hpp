#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace percuss::inline core {

/// Unusable input: a file, an option's value or their combination. The message is one line that names the place and the
/// remedy.
///   "problem (where); remedy"
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view problem, std::string_view where, std::string_view remedy);
  /// One that was reported in another process, by its message.
  static InputError with_message(const std::string& message) { return InputError(message); }

 private:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// What is said where memory ran out.
inline constexpr const char* kOutOfMemoryMessage =
    "not enough memory (the whole run); analyse fewer rows or channels at a time";

/// The command line asks for something that percuss does not offer. Same form of message.
class UsageError : public std::runtime_error {
 public:
  UsageError(std::string_view problem, std::string_view remedy);
};

/// `text` as it may stand inside a one-line message: control characters shown as '?', cut after `limit` bytes at most,
/// never inside a UTF-8 character, with "...".
std::string one_line(std::string_view text, std::size_t limit = 200);

}  // namespace percuss::inline core
