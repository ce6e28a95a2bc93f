#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "percuss/error.hpp"

namespace percuss {
inline namespace core {

/// A message that states only how something was read or done: nothing is in doubt.
inline Message information(std::string text) {
  Message message(std::move(text));
  message.information = true;
  return message;
}

/// `message` with this Message::code.
inline Message with_code(Message message, std::string code) {
  message.code = std::move(code);
  return message;
}

/// The message that an interface shows for std::bad_alloc, in the form of InputError: "problem (where); remedy".
inline constexpr const char* kOutOfMemoryMessage =
    "not enough memory (the whole run); analyse fewer rows or channels at a time";

/// The command line requests something that percuss does not offer. what() is "problem; remedy".
class UsageError : public std::runtime_error {
 public:
  UsageError(std::string_view problem, std::string_view remedy);
};

/// The machine failed, not the input: it has no process, descriptor or memory left, its disk is full or cannot be read.
/// The same work may succeed later.
class MachineFault : public InputError {
 public:
  using InputError::InputError;
};

/// Whether a value of errno tells of the machine's state: EAGAIN, ENOMEM, EMFILE, ENOSPC, EIO, …
bool is_machine_fault(int error);

/// Throws a MachineFault if is_machine_fault(error), otherwise an InputError. The message is `problem`, a colon and the
/// text of `error`, a value of errno.
[[noreturn]] void throw_system_error(std::string_view problem, int error, std::string_view where,
                                     std::string_view remedy);

/// `text` for use inside a one-line message: its characters as take_visible() shows them, line ends too. A longer text
/// is cut after at most `limit` bytes, never inside a character, and ends with "...".
std::string one_line(std::string_view text, std::size_t limit = 200);

}  // namespace core
}  // namespace percuss
