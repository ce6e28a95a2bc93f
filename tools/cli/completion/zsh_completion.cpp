#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/completion/completion_scripts.hpp"

namespace percuss::tools {
namespace {

// Text for use between single quotes, with a backslash before each character of `special`.
std::string zsh_quoted(std::string_view text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  }
  return out;
}

std::string function_of(const Declaration& all, const DeclaredCommand& command) {
  std::string name = "_" + full_name(all, command);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// The completion of a value: "(quick standard best)".
std::string action_of(const DeclaredOption& option) {
  if (option.list && !option.choices.empty())
    return fmt::format("_values -s , value {}", fmt::join(option.choices, " "));
  if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
  std::string files = option.kind == ArgumentKind::folder ? "_files -/" : "_files";
  if (option.kind == ArgumentKind::text) return " ";
  if (option.suggestions.empty()) return files;
  return fmt::format("{{compadd -- {}; {}}}", fmt::join(option.suggestions, " "), files);
}

// '(-o --output)-o+[Write to …]:FILE:_files'
std::string option_specs(const DeclaredOption& option) {
  std::string out;
  for (const std::string& name : option.names) {
    const std::string once = option.repeatable ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    const char* const join = option.is_flag() ? "" : name.starts_with("--") ? "=" : "+";
    const std::string value =
        option.is_flag() ? "" : ":" + zsh_quoted(option.value, ":\\") + ":" + zsh_quoted(action_of(option), ":");
    out +=
        fmt::format(" \\\n    '{}{}{}[{}]{}'", once, name, join, zsh_quoted(option_help_text(option), "[]:\\"), value);
  }
  return out;
}

std::string argument_specs(const DeclaredCommand& command) {
  std::string out;
  for (const DeclaredOption& argument : command.arguments) {
    out += fmt::format(" \\\n    '{}:{}:{}'", argument.repeatable ? "*" : "1", zsh_quoted(argument.name(), ":\\"),
                       zsh_quoted(action_of(argument), ":"));
  }
  return out;
}

// A group passes the remaining words to the function of the named command. After the word help, it does so only if this
// command is a group as well.
std::string group_function(const Declaration& all, const DeclaredCommand& command, const std::string& specs) {
  std::string names, calls;
  for (const DeclaredCommand* one : commands_of(all, command)) {
    names += fmt::format("\n        '{}:{}'", base_name(*one), zsh_quoted(one->summary, ":\\"));
    const char* const unless_help = one->is_group ? "" : "[[ -z ${percuss_help:-} ]] && ";
    calls += fmt::format("\n        {}) {}{} && ret=0 ;;", base_name(*one), unless_help, function_of(all, *one));
  }
  // After the word help, the function of the program completes the commands again.
  if (command.name.empty())
    calls += fmt::format("\n        help) local percuss_help=1; {} && ret=0 ;;", function_of(all, command));
  return fmt::format(R"({}() {{
  local context state state_descr line ret=1
  typeset -A opt_args
  _arguments -C{} \
    '1:COMMAND:->command' '*::WORD:->word' && ret=0
  case $state in
    command)
      local -a commands=({})
      _describe command commands && ret=0 ;;
    word)
      case $line[1] in{}
      esac ;;
  esac
  return ret
}}
)",
                     function_of(all, command), specs, names, calls);
}

std::string command_function(const Declaration& all, const DeclaredCommand& command) {
  std::string specs;
  for (const DeclaredOption& option : command.options) specs += option_specs(option);
  if (command.is_group) return group_function(all, command, specs);
  return fmt::format("{}() {{\n  _arguments -S{}{}\n}}\n", function_of(all, command), specs, argument_specs(command));
}

}  // namespace

std::string zsh_completion(const Declaration& all) {
  std::string out = fmt::format("#compdef {}\n# {} {}, completion for zsh, made by: {} completion zsh\n", all.program,
                                all.program, all.version, all.program);
  for (const DeclaredCommand& command : all.commands) out += command_function(all, command);
  const std::string main = function_of(all, all.commands.front());
  // In fpath, the file runs as the first call of the function; when sourced, it only registers the function.
  return out + fmt::format("if [[ $funcstack[1] == {} ]]; then\n  {} \"$@\"\nelse\n  compdef {} {}\nfi\n", main, main,
                           main, all.program);
}

}  // namespace percuss::tools
