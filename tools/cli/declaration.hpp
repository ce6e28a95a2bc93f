#pragma once
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::tools {

enum class ArgumentKind { text, file, folder };

/// An option, or a word without dashes, as it was declared. The parser's complaints, --help, the manual pages and the
/// shells' completion all read this and nothing else.
struct DeclaredOption {
  std::vector<std::string> names;        // {"-o", "--output"}; of a word its one name, "FILE"
  std::string value;                     // how its value is shown, "HZ"; empty: a flag takes none, a word is its own
  std::vector<std::string> choices;      // all that it may be; empty: more than can be listed
  std::vector<std::string> suggestions;  // some that it may be, for a shell to complete
  std::string wanted;                    // what its value must be, "a number above 0"
  std::string initial;                   // its value where it is not given
  std::string help;
  std::string group;  // the heading it stands under; empty: none of its own
  ArgumentKind kind = ArgumentKind::text;
  bool required = false;
  bool repeatable = false;
  bool list = false;   // one word may be several values: "0,90"
  bool whole = false;  // its value is a whole number

  const std::string& name() const { return names.back(); }  // the long one
  bool is_flag() const { return value.empty() && names.back().front() == '-'; }
};

struct DeclaredExample {
  std::string line;     // as it is typed into a shell
  std::string meaning;  // what it does
};

/// The program itself (its name is empty), a command, or a group of commands.
struct DeclaredCommand {
  std::string name;     // "model beam"
  std::string summary;  // one line
  std::string about;    // a paragraph
  bool is_group = false;
  std::deque<DeclaredOption> words, options;  // pointers to them stay valid while more are declared
  std::vector<DeclaredExample> examples;
};

struct DeclaredExit {
  int code = 0;
  std::string meaning;
};

struct Declaration {
  std::string program, version;
  std::deque<DeclaredCommand> commands;  // the program first, a group before its commands
  std::vector<DeclaredExit> exits;
};

/// "percuss model beam".
std::string called(const Declaration& all, const DeclaredCommand& command);

/// The last word of its name, "beam".
std::string last_name(const DeclaredCommand& command);

/// Those named one word longer, in the order of their declaration.
std::vector<const DeclaredCommand*> commands_of(const Declaration& all, const DeclaredCommand& parent);

/// The command of this name, or none.
const DeclaredCommand* find_command(const Declaration& all, std::string_view name);

/// The option that is called so, "-o" or "--output", or none.
const DeclaredOption* find_option(const DeclaredCommand& command, std::string_view name);

/// "percuss calibrate --mass KG [OPTION]... [FILE...]", in parts: those to be typed as they are start with a dash or
/// are the first.
std::vector<std::string> usage_of(const Declaration& all, const DeclaredCommand& command);

struct OptionGroup {
  std::string heading;
  std::vector<const DeclaredOption*> options;
};

/// The options under their headings: those without one of their own first.
std::vector<OptionGroup> groups_of(const DeclaredCommand& command);

/// The help of an option and its initial value.
std::string option_help_text(const DeclaredOption& option);

}  // namespace percuss::tools
