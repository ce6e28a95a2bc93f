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

/// An option just declared; what follows says what its value must be and how it is shown.
class Option {
 public:
  Option(CLI::Option* option, DeclaredOption* declared) : option_(option), declared_(declared) {}
  /// In place of the value: a unit or a form. FILE and FOLDER are completed by shells.
  Option type(const char* shown);
  Option one_of(const std::vector<std::string>& names);
  Option suggest(const std::vector<std::string>& names);  // for shells to complete; others are taken as well
  Option within(double low, double high);                 // both included
  // Unlike CLI11's own checks these refuse NaN and infinity, and say so in words.
  Option above_zero();
  Option not_negative();
  Option finite();
  Option counted();  // digits only: CLI11 would take −1 as a very large count
  Option required();
  Option show_default();

 private:
  friend class Command;
  Option holds(std::string wanted, const std::function<bool(const std::string&)>& check);

  CLI::Option* option_;
  DeclaredOption* declared_;
};

/// One subcommand's options, bound to the variables that receive them, which must outlive the parse.
class Command {
 public:
  Command(CLI::App* app, DeclaredCommand* declared, Host* host = nullptr)
      : app_(app), declared_(declared), host_(host) {}
  /// Who runs the command in its own process; nullptr: a shell.
  Host* host() const { return host_; }
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
  /// What was given of the options shown under `heading`, as words that say the same once more: "--band=60:3200".
  std::vector<std::string> given(const std::string& heading) const;
  /// The options declared from here on are shown under `name`; returns what they were shown under before.
  std::string heading(const std::string& name);
  /// A paragraph for who does not know the command: what goes in, what comes out, in which units.
  void about(const char* text);
  /// A line as it is typed into a shell, and what it does. The tests run it.
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
