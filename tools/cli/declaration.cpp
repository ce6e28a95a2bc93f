#include "cli/declaration.hpp"

#include <algorithm>

namespace percuss::tools {
namespace {

std::string_view parent_name(std::string_view name) {
  const std::size_t blank = name.rfind(' ');
  return blank == std::string_view::npos ? std::string_view() : name.substr(0, blank);
}

}  // namespace

std::string full_name(const Declaration& all, const DeclaredCommand& command) {
  return command.name.empty() ? all.program : all.program + " " + command.name;
}

std::string base_name(const DeclaredCommand& command) { return command.name.substr(command.name.rfind(' ') + 1); }

std::vector<const DeclaredCommand*> commands_of(const Declaration& all, const DeclaredCommand& parent) {
  std::vector<const DeclaredCommand*> found;
  for (const DeclaredCommand& one : all.commands) {
    if (!one.name.empty() && parent_name(one.name) == parent.name) found.push_back(&one);
  }
  return found;
}

const DeclaredCommand* find_command(const Declaration& all, std::string_view name) {
  const auto found =
      std::find_if(all.commands.begin(), all.commands.end(), [&](const auto& one) { return one.name == name; });
  return found == all.commands.end() ? nullptr : &*found;
}

CommandMatch longest_command(const Declaration& all, const std::vector<std::string>& words) {
  CommandMatch found{.command = &all.commands.front()};
  for (const std::string& word : words) {
    const std::string& group = found.command->name;
    const DeclaredCommand* const next =
        word.empty() ? nullptr : find_command(all, group.empty() ? word : group + " " + word);
    if (next == nullptr) break;
    found = {.command = next, .words = found.words + 1};
  }
  return found;
}

const DeclaredOption* find_option(const DeclaredCommand& command, std::string_view name) {
  for (const DeclaredOption& option : command.options) {
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  }
  return nullptr;
}

std::vector<std::string> usage_of(const Declaration& all, const DeclaredCommand& command) {
  std::vector<std::string> parts{full_name(all, command)};
  for (const DeclaredOption& option : command.options) {
    if (option.required) parts.push_back(option.name() + " " + option.value);
  }
  parts.emplace_back("[OPTION]...");
  if (!commands_of(all, command).empty()) parts.emplace_back("COMMAND");
  for (const DeclaredOption& argument : command.arguments) {
    const std::string shown = argument.name() + (argument.repeatable ? "..." : "");
    parts.push_back(argument.required ? shown : "[" + shown + "]");
  }
  return parts;
}

std::vector<OptionGroup> groups_of(const DeclaredCommand& command) {
  std::vector<OptionGroup> groups{{.heading = "", .options = {}}};
  for (const DeclaredOption& option : command.options) {
    auto at = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.heading == option.group; });
    if (at == groups.end()) at = groups.insert(groups.end(), {.heading = option.group, .options = {}});
    at->options.push_back(&option);
  }
  return groups;
}

std::string option_help_text(const DeclaredOption& option) {
  std::string text = option.help;
  if (option.list) {  // the placeholder does not list the choices
    for (const std::string& choice : option.choices)
      text += (&choice == &option.choices.front() ? ": " : ", ") + choice;
  }
  return option.initial.empty() ? text : text + " (default: " + option.initial + ")";
}

}  // namespace percuss::tools
