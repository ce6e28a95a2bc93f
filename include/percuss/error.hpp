#pragma once
/// Errors as data: every function throws InputError for input that cannot be used.
///
/// what() is one line, "problem (where); remedy". options() holds the identifiers of the options concerned; they are
/// the same for the command line (--accel-channel), Python (accel_channel=) and C++. The rule for C++: the field of an
/// options aggregate has the identifier as its name, followed by its unit where it has one: "fs" is ReadOptions::fs_Hz.
/// There are two exceptions. "force" (overwrite files) is WriteOptions::overwrite: in C++ a force is a signal.
/// "overlay_db" is AnalysisOptions::overlay_dB.
/// option_field() applies the rule, written() appends the fields to the message.
///
/// @code
/// #include <iostream>
/// #include <percuss/error.hpp>
/// #include <percuss/record.hpp>
///
/// int main() {
///   try {
///     percuss::open_record("missing.h5", {.fs_Hz = 25600});
///   } catch (const percuss::InputError& error) {
///     std::cout << error.problem() << " | " << error.where() << " | " << error.remedy() << '\n';
///     std::cout << error.written(percuss::option_field) << '\n';
///   }
/// }
/// @endcode
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace percuss {

/// An option's identifier, the same in every interface: "fs", "accel_channel". "survey.example" is the option `example`
/// of the command `survey`. The command line writes --accel-channel, Python accel_channel=.
using OptionId = std::string;

/// How an interface writes an option.
using OptionWriter = std::string (*)(std::string_view id);

/// The field of a C++ options aggregate: "fs" gives "ReadOptions::fs_Hz". An identifier that no field has is returned
/// unchanged: the option belongs to a command of the tool.
std::string option_field(std::string_view id);

/// A sentence and the options that it concerns.
struct Message {
  Message() = default;
  Message(std::string what, std::vector<OptionId> concerned = {})
      : text(std::move(what)), options(std::move(concerned)) {}
  Message(const char* what, std::vector<OptionId> concerned = {}) : Message(std::string(what), std::move(concerned)) {}

  std::string text;
  std::vector<OptionId> options;
  bool information = false;  // states only how something was read or done: nothing is in doubt
  std::string code;          // identifies a message that the analysis acts on; mostly empty

  /// "text (--fs, --unit)"; only the text where `options` is empty. Options of other commands follow "see":
  /// "text (--geometry; see percuss survey --example)".
  std::string written(OptionWriter write) const;
  bool operator==(const Message&) const = default;
};

/// Unusable input: a file, an option's value or their combination. what() is one line, "problem (where); remedy". It
/// names no options: each interface adds them in its own notation. No field holds control characters. A field of more
/// than 600 bytes is cut and ends in "...".
///   throw InputError("no sampling rate", path, "state it in Hz", {"fs"});
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view problem, std::string_view where, std::string_view remedy,
             std::vector<OptionId> options = {});

  const std::string& problem() const { return problem_; }
  const std::string& where() const { return where_; }
  const std::string& remedy() const { return remedy_; }
  const std::vector<OptionId>& options() const { return options_; }
  /// what() and the options in the interface's notation.
  std::string written(OptionWriter write) const;

 private:
  std::string problem_, where_, remedy_;
  std::vector<OptionId> options_;
};

}  // namespace percuss
