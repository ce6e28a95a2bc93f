#include <fmt/format.h>

#include "cli/completion/completion_scripts.hpp"

namespace percuss::tools {
namespace {

// Finds the command and the word before the cursor. bash treats "=" as a word. After the first word "help", only the
// names of commands follow.
constexpr const char* kBegin = R"(_percuss() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  local command='' options='' values='' kind='' list='' head='' below='' begin=1 at
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $before == '=' ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if ((COMP_CWORD > 1)) && [[ ${COMP_WORDS[1]} == help ]]; then
    begin=2
  fi
  for ((at = begin; at < COMP_CWORD; ++at)); do
    case "$command ${COMP_WORDS[at]}" in
)";

constexpr const char* kCommands = R"(        command="${command:+$command }${COMP_WORDS[at]}" ;;
      *) break ;;
    esac
  done
  case "$command" in
)";

// `options` is empty if the option before the cursor takes a value.
constexpr const char* kEnd = R"(  esac
  if ((begin == 2)); then
    options=''
    values=$below
    kind=text
  fi
  if [[ -n $options && $current == -* ]]; then
    values=$options
    kind=text
  fi
  if [[ -n $list && $current == *,* ]]; then
    head=${current%,*},
    current=${current##*,}
  fi
  mapfile -t COMPREPLY < <(compgen -P "$head" -W "$values" -- "$current")
  if [[ $kind == file ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$current")
  elif [[ $kind == folder ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$current")
  fi
}
complete -F _percuss percuss
)";

const char* kind_name(ArgumentKind kind) {
  return kind == ArgumentKind::file ? "file" : kind == ArgumentKind::folder ? "folder" : "text";
}

// "values='quick standard best' kind=text".
std::string values_of(const DeclaredOption& option) {
  const auto& names = option.choices.empty() ? option.suggestions : option.choices;
  const std::string values = names.empty() ? "" : fmt::format("values='{}' ", fmt::join(names, " "));
  return fmt::format("{}kind={}{}", values, kind_name(option.kind), option.list ? " list=1" : "");
}

std::string value_cases(const DeclaredCommand& command) {
  std::string out, plain;
  for (const DeclaredOption& option : command.options) {
    if (option.is_flag()) continue;
    const std::string names = fmt::format("{}", fmt::join(option.names, " | "));
    if (option.kind == ArgumentKind::text && option.choices.empty()) {
      plain += (plain.empty() ? "" : " | ") + names;
    } else {
      out += fmt::format("        {}) options='' {} ;;\n", names, values_of(option));
    }
  }
  return plain.empty() ? out : out + fmt::format("        {}) return ;;\n", plain);
}

std::string command_case(const Declaration& all, const DeclaredCommand& command) {
  std::vector<std::string> options, below;
  for (const DeclaredOption& option : command.options)
    options.insert(options.end(), option.names.begin(), option.names.end());
  for (const DeclaredCommand* one : commands_of(all, command)) below.push_back(base_name(*one));
  std::string words = below.empty() ? "" : fmt::format(" below='{}' values=$below kind=text", fmt::join(below, " "));
  if (!command.arguments.empty()) words = " " + values_of(command.arguments.front());
  const std::string values = value_cases(command);
  return fmt::format("    '{}')\n      options='{}'{}\n{} ;;\n", command.name, fmt::join(options, " "), words,
                     values.empty() ? "     " : "      case \"$before\" in\n" + values + "      esac");
}

}  // namespace

std::string bash_completion(const Declaration& all) {
  std::vector<std::string> known;
  for (const DeclaredCommand& one : all.commands) {
    if (!one.name.empty()) known.push_back((one.name.find(' ') == std::string::npos ? "' " : "'") + one.name + "'");
  }
  std::string out =
      fmt::format("# {} {}, completion for bash, made by: {} completion bash\n", all.program, all.version, all.program);
  out += kBegin + fmt::format("      {})\n", fmt::join(known, " | ")) + kCommands;
  for (const DeclaredCommand& command : all.commands) out += command_case(all, command);
  return out + kEnd;
}

}  // namespace percuss::tools
