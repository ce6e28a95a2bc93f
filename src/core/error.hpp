#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace percuss::inline core {

/// An option by its identifier, the same for every interface: "fs", "accel_channel"; "survey.example" is the option
/// `example` of the command `survey`. The command line writes --accel-channel, Python accel_channel=.
using OptionId = std::string;

/// How an interface writes an option.
using OptionWriter = std::string (*)(std::string_view id);

/// A sentence for people, and the options that it is about.
struct Message {
  Message() = default;
  Message(std::string what, std::vector<OptionId> concerned = {})
      : text(std::move(what)), options(std::move(concerned)) {}
  Message(const char* what, std::vector<OptionId> concerned = {}) : Message(std::string(what), std::move(concerned)) {}

  std::string text;
  std::vector<OptionId> options;

  /// "text (--fs, --unit)"; the text alone where no option belongs to it.
  std::string written(OptionWriter write) const;
  bool operator==(const Message&) const = default;
};

/// Unusable input: a file, an option's value or their combination. what() is one line, "problem (where); remedy",
/// without options: an interface writes those in its own words.
///   throw InputError("no sampling rate", path, "state it in Hz", {"fs"});
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view problem, std::string_view where, std::string_view remedy,
             std::vector<OptionId> options = {});
  /// An error that another process reported by its message.
  static InputError with_message(const std::string& message, std::vector<OptionId> options = {});

  const std::string& problem() const { return problem_; }
  const std::string& where() const { return where_; }
  const std::string& remedy() const { return remedy_; }
  const std::vector<OptionId>& options() const { return options_; }
  /// what(), and the options as the interface writes them.
  std::string written(OptionWriter write) const;

 private:
  InputError(const std::string& message, std::vector<OptionId> options);

  std::string problem_, where_, remedy_;
  std::vector<OptionId> options_;
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
