#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_options.hpp"

namespace percuss::tools {

/// The tool's command line. CLI11 parses it, behind this: it takes seconds to compile wherever it is seen.
class CommandLine {
 public:
  /// `host` is who runs its commands, where that is not a shell.
  CommandLine(const char* name, const char* description, const char* version, Host* host = nullptr);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The program itself: its options, examples and what it is about.
  Command program();

  /// A command that only gathers others: they are named "GROUP NAME" and declared after it.
  Command group(const char* name, const char* description);

  /// `run` is called when the command was chosen and its options understood; it returns an exit code.
  Command command(const char* name, const char* description, std::function<int()> run);

  /// The variables that a command's options are bound to. Each run finds them as they were declared, so that one
  /// declaration serves many runs, one after the other.
  template <class Values>
  std::shared_ptr<Values> values() {
    auto made = std::make_shared<Values>();
    resets_.emplace_back([made, initial = std::optional<Values>()]() mutable {
      if (!initial) initial = *made;
      *made = *initial;
    });
    return made;
  }

  /// What an exit code means, for the manual pages.
  void exit_code(int code, const char* meaning);

  const Declaration& declaration() const { return declaration_; }

  /// Runs what the words ask for; 0 after --help and --version. Throws UsageError for words it does not understand.
  int run(int argc, const char* const* argv);

 private:
  DeclaredCommand* declare(const char* name, const char* description);
  void check_commands(const std::vector<std::string>& words) const;

  Host* host_;
  Declaration declaration_;
  std::unique_ptr<CLI::App> app_;
  std::function<int()> chosen_;
  std::vector<std::function<void()>> resets_;
};

}  // namespace percuss::tools
