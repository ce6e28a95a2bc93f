#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/declaration.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace percuss::tools {

struct Host;

/// A declared option; the methods set its allowed values and how help shows them.
class Option {
 public:
  Option(CLI::Option* option, DeclaredOption* declared) : option_(option), declared_(declared) {}
  /// The placeholder of the value: a unit or a form. Shells complete FILE and FOLDER.
  Option type(const char* shown);
  Option one_of(const std::vector<std::string>& names);
  Option suggest(const std::vector<std::string>& names);  // completed by shells; other values are valid too
  Option within(double low, double high);                 // inclusive
  // Unlike the checks of CLI11, these reject NaN and infinity.
  Option above_zero();
  Option not_negative();
  Option finite();
  Option counted();  // digits only: CLI11 reads −1 as a very large count
  /// Checks each value. If the check fails, the message says "give" and then `requirement`.
  Option add_check(std::string requirement, const std::function<bool(const std::string&)>& check);
  Option required();
  Option show_default();

 private:
  friend class Command;

  CLI::Option* option_;
  DeclaredOption* declared_;
};

/// The options of one command, bound to variables, which must outlive the parse.
class Command {
 public:
  Command(CLI::App* app, DeclaredCommand* declared, Host* host = nullptr)
      : app_(app), declared_(declared), host_(host) {}
  /// The program that calls the command as a function; nullptr: a shell.
  Host* host() const { return host_; }
  /// A positional argument, or a list of them.
  Option argument(const char* name, std::string& value, const char* help);
  Option arguments(const char* name, std::vector<std::string>& values, const char* help);
  Option value(const char* names, std::string& value, const char* help);
  Option value(const char* names, double& value, const char* help);
  Option value(const char* names, std::size_t& value, const char* help);
  Option value(const char* names, std::optional<double>& value, const char* help);
  Option value(const char* names, std::optional<std::size_t>& value, const char* help);
  Option value(const char* names, const std::function<void(const std::string&)>& set, const char* help);
  /// A repeatable option with one value each time, so that files may follow it.
  Option repeatable(const char* names, std::vector<std::string>& values, const char* help);
  /// A repeatable option whose value is a list: "0,90".
  Option list(const char* names, std::vector<std::string>& values, const char* help);
  Option list(const char* names, std::vector<double>& values, const char* help);
  Option list(const char* names, std::vector<std::size_t>& values, const char* help);
  void flag(const char* names, bool& value, const char* help);
  /// The given options under `heading` in canonical form: "--band=60:3200".
  std::vector<std::string> given(const std::string& heading) const;
  /// Sets the heading of the options declared from here on; returns the previous heading.
  std::string heading(const std::string& name);
  /// A paragraph on input, output and units.
  void about(const char* text);
  /// An example command line and its purpose. The tests run it.
  void example(const char* command_line, const char* meaning = "");

 private:
  Option declared(const char* names, const char* value, const char* help, CLI::Option* option);
  Option repeated(const char* names, const char* value, const char* help, CLI::Option* option);
  Option listed(const char* names, const char* value, const char* help, CLI::Option* option);

  CLI::App* app_;
  DeclaredCommand* declared_;
  Host* host_;
  std::string group_;
};

}  // namespace percuss::tools
