#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace percuss::tools {

/// An option just declared; what follows says what its value must be and how --help shows it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option type(const char* shown);  // in place of the value
  Option one_of(const std::vector<std::string>& names);
  Option within(double low, double high);  // both included
  // Unlike CLI11's own checks these refuse NaN and infinity, and say so in words.
  Option above_zero();
  Option not_negative();
  Option finite();
  Option counted();  // digits only: CLI11 would take −1 as a very large count
  Option required();
  Option show_default();

 private:
  CLI::Option* option_;
};

/// One subcommand's options, bound to the variables that receive them, which must outlive the parse.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}
  Option word(const char* name, std::string& value, const char* help);                 // without dashes
  Option words(const char* name, std::vector<std::string>& values, const char* help);  // … as many as are given
  Option value(const char* names, std::string& value, const char* help);
  Option value(const char* names, double& value, const char* help);
  Option value(const char* names, std::size_t& value, const char* help);
  Option value(const char* names, std::optional<double>& value, const char* help);
  Option value(const char* names, std::optional<std::size_t>& value, const char* help);
  Option value(const char* names, const std::function<void(const std::string&)>& set, const char* help);
  /// One word per mention, so that the words after it are files again.
  Option repeatable(const char* names, std::vector<std::string>& values, const char* help);
  /// The same, and a word may be several values: "0,90".
  Option list(const char* names, std::vector<std::string>& values, const char* help);
  Option list(const char* names, std::vector<double>& values, const char* help);
  Option list(const char* names, std::vector<std::size_t>& values, const char* help);
  void flag(const char* names, bool& value, const char* help);
  /// --help shows the options declared from here on under `name`; returns what they were shown under before.
  std::string heading(const std::string& name);
  void example(const char* command_line);

 private:
  CLI::App* app_;
};

/// The tool's command line. CLI11 parses it, behind this: it takes seconds to compile wherever it is seen.
class CommandLine {
 public:
  CommandLine(const char* name, const char* description, const char* version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// A command that only gathers others: they are named "GROUP NAME" and declared after it.
  void group(const char* name, const char* description);

  /// `run` is called when the command was chosen and its options understood; it returns an exit code.
  Command command(const char* name, const char* description, std::function<int()> run);

  /// Runs what the words ask for; 0 after --help and --version. Throws UsageError for words it does not understand.
  int run(int argc, char** argv);

 private:
  void check_commands(int argc, char** argv) const;

  std::unique_ptr<CLI::App> app_;
  std::function<int()> chosen_;
};

}  // namespace percuss::tools
