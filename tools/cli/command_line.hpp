#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_options.hpp"

namespace percuss::tools {

/// The tool's command line. It hides CLI11, whose headers take seconds to compile.
class CommandLine {
 public:
  /// `host` is the program that calls the commands as functions, if any.
  CommandLine(const char* name, const char* description, const char* version, Host* host = nullptr);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The program itself: its options, examples and description.
  Command program();

  /// A group of commands; its commands are named "GROUP NAME" and declared after it.
  Command group(const char* name, const char* description);

  /// `run` executes the command after a successful parse and returns the exit code.
  Command command(const char* name, const char* description, std::function<int()> run);

  /// The variables of a command's options. Each run starts from their initial values, so one declaration serves many
  /// runs.
  template <class Values>
  std::shared_ptr<Values> values() {
    struct Stored {
      std::optional<Values> initial, parsed;
    };
    auto made = std::make_shared<Values>();
    const auto stored = std::make_shared<Stored>();
    const auto reset = [made, stored] {
      if (!stored->initial) stored->initial = *made;
      *made = *stored->initial;
    };
    variables_.push_back({.reset = reset,
                          .keep = [made, stored] { stored->parsed = *made; },
                          .restore = [made, stored] { *made = *stored->parsed; }});
    return made;
  }

  /// Declares the meaning of an exit code for the manual pages.
  void exit_code(int code, const char* meaning);

  const Declaration& declaration() const { return declaration_; }

  /// Parses and runs a command line; returns 0 after --help and --version. Throws UsageError for an invalid one. With
  /// a host, a run with the same words as the last one is not parsed again: parsing takes longer than many commands.
  int run(int argc, const char* const* argv);

 private:
  DeclaredCommand* declare(const char* name, const char* description);
  void check_commands(const std::vector<std::string>& words) const;
  int show_help(const std::vector<std::string>& command_words) const;
  /// False after --help and --version, which it has answered.
  bool parse(const std::vector<std::string>& typed);

  /// The variables of a command: their initial values, and the values of the last parse.
  struct Variables {
    std::function<void()> reset, keep, restore;
  };

  Host* host_;
  Declaration declaration_;
  std::unique_ptr<CLI::App> app_;
  std::function<int()> chosen_;
  std::vector<Variables> variables_;
  std::vector<std::string> kept_words_;  // words of the last parse, whose values are kept; empty: none are
};

}  // namespace percuss::tools
