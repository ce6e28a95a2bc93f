#include <fmt/format.h>

#include <string_view>

#include "cli/completion/completion_scripts.hpp"

namespace percuss::tools {
namespace {

std::string fish_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

// __percuss_words gives the command in a list of words. __percuss_command tests whether the words before the cursor are
// this command; __percuss_group also accepts them after the word help. __percuss_list completes list values after a
// comma.
constexpr const char* kFunctions = R"(function __percuss_words
    set -l command
    for word in $argv
        switch "$command $word"
            case {}
                set -a command $word
            case '*'
                break
        end
    end
    echo "$command"
end
function __percuss_command
    set -l words (commandline -opc)
    test (__percuss_words $words[2..-1]) = "$argv"
    and test "$words[2]" != help
end
function __percuss_group
    set -l words (commandline -opc)
    test "$words[2]" = help
    and set -e words[2]
    test (__percuss_words $words[2..-1]) = "$argv"
end
function __percuss_list
    set -l before (commandline -ct | string replace -r '^--[^=]*=' '' | string match -r '.*,')
    printf '%s\n' "$before"$argv
end
complete -c percuss -f
)";

// The completion of a value, as options of the command complete of fish.
std::string value_flags(const DeclaredOption& option) {
  const auto& names = option.choices.empty() ? option.suggestions : option.choices;
  const std::string all = fmt::format("{}", fmt::join(names, " "));
  std::string out;
  if (option.list && !names.empty()) return " -x -a " + fish_quoted("(__percuss_list " + all + ")");
  if (!names.empty()) out = " -a " + fish_quoted(all);
  if (option.kind == ArgumentKind::folder) return out + " -x -a '(__fish_complete_directories)'";
  return out + (option.kind == ArgumentKind::file ? " -r -F" : " -x");
}

std::string option_line(const DeclaredOption& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return out + (option.is_flag() ? "" : value_flags(option)) + " -d " + fish_quoted(option_help_text(option));
}

std::string argument_line(const DeclaredOption& argument) {
  const auto& names = argument.choices.empty() ? argument.suggestions : argument.choices;
  const std::string listed = names.empty() ? "" : " -a " + fish_quoted(fmt::format("{}", fmt::join(names, " ")));
  return listed + (argument.kind == ArgumentKind::file ? " -F" : "") + " -d " + fish_quoted(argument.help);
}

}  // namespace

std::string fish_completion(const Declaration& all) {
  std::string known;
  for (const DeclaredCommand& one : all.commands) {
    if (one.name.empty()) continue;
    known +=
        (known.empty() ? "'" : " '") + std::string(one.name.find(' ') == std::string::npos ? " " : "") + one.name + "'";
  }
  std::string out =
      fmt::format("# {} {}, completion for fish, made by: {} completion fish\n", all.program, all.version, all.program);
  out += fmt::format(fmt::runtime(kFunctions), known);
  for (const DeclaredCommand& command : all.commands) {
    const std::string here =
        fmt::format("complete -c {} -n {}", all.program, fish_quoted("__percuss_command " + command.name));
    const std::string group =
        fmt::format("complete -c {} -n {}", all.program, fish_quoted("__percuss_group " + command.name));
    for (const DeclaredCommand* one : commands_of(all, command))
      out += group + " -a " + base_name(*one) + " -d " + fish_quoted(one->summary) + "\n";
    for (const DeclaredOption& argument : command.arguments) out += here + argument_line(argument) + "\n";
    for (const DeclaredOption& option : command.options) out += here + option_line(option) + "\n";
  }
  return out;
}

}  // namespace percuss::tools
