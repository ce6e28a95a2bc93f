#pragma once
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

enum class ArgumentKind { text, file, folder };

/// A declared option or positional argument: the one source of usage errors, --help, manual pages, completion scripts
/// and the keywords of Python.
struct DeclaredOption {
  std::vector<std::string> names;        // {"-o", "--output"}; for an argument {"FILE"}
  std::string value;                     // placeholder of the value, "HZ"; empty for flags and arguments
  std::vector<std::string> choices;      // all allowed values; empty: not a fixed list
  std::vector<std::string> suggestions;  // values for a shell to complete
  std::string requirement;               // rule for the value, "a number above 0"
  std::string initial;                   // default value
  std::string help;
  std::string group;  // heading in the help; empty: none
  ArgumentKind kind = ArgumentKind::text;
  bool required = false;
  bool repeatable = false;
  bool list = false;   // the value is a list: "0,90"
  bool whole = false;  // the value is a whole number

  const std::string& name() const { return names.back(); }  // the long name
  bool is_flag() const { return value.empty() && names.back().front() == '-'; }
};

struct DeclaredExample {
  std::string line;     // as typed into a shell
  std::string meaning;  // its purpose
};

/// The program itself (with an empty name), a command, or a group of commands.
struct DeclaredCommand {
  std::string name;     // "model beam"
  std::string summary;  // one line
  std::string about;    // a paragraph
  bool is_group = false;
  std::deque<DeclaredOption> arguments, options;  // a deque keeps pointers to its elements valid
  std::vector<DeclaredExample> examples;
};

struct DeclaredExit {
  int code = 0;
  std::string meaning;
};

struct Declaration {
  std::string program, version;
  std::deque<DeclaredCommand> commands;  // the program first; a group before its commands
  std::vector<DeclaredExit> exits;
};

/// "percuss model beam".
std::string full_name(const Declaration& all, const DeclaredCommand& command);

/// The last word of the command's name, "beam".
std::string base_name(const DeclaredCommand& command);

/// The direct subcommands, in the order of declaration.
std::vector<const DeclaredCommand*> commands_of(const Declaration& all, const DeclaredCommand& parent);

/// The command of this name, or nullptr.
const DeclaredCommand* find_command(const Declaration& all, std::string_view name);

/// A command or group, and how many words name it.
struct CommandMatch {
  const DeclaredCommand* command = nullptr;
  std::size_t words = 0;
};

/// The longest command that the first words name; the program itself if they name none.
CommandMatch longest_command(const Declaration& all, const std::vector<std::string>& words);

/// The option with this name, "-o" or "--output", or nullptr.
const DeclaredOption* find_option(const DeclaredCommand& command, std::string_view name);

/// The parts of "percuss calibrate --mass KG [OPTION]... [FILE...]". The first part, and parts that start with a dash,
/// are typed literally.
std::vector<std::string> usage_of(const Declaration& all, const DeclaredCommand& command);

struct OptionGroup {
  std::string heading;
  std::vector<const DeclaredOption*> options;
};

/// The options by heading; options without a heading come first.
std::vector<OptionGroup> groups_of(const DeclaredCommand& command);

/// The help text of an option, with its choices and default value.
std::string option_help_text(const DeclaredOption& option);

}  // namespace percuss::tools
