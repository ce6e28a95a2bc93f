#include "cli/usage_errors.hpp"

#include "cli/nearest.hpp"
#include "cli/option_names.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kTypedBytes = 40;  // bytes of a typed word that a message shows

std::string option_word(const std::string& typed) { return one_line(typed.substr(0, typed.find('=')), kTypedBytes); }

std::string typed_word(const std::string& typed) { return "'" + one_line(typed, kTypedBytes) + "'"; }

// "quick, standard or best".
std::string one_of_these(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return out;
}

// "--band LO:HI".
std::string form(const DeclaredOption& option) {
  return option.value.empty() ? option.name() : option.name() + " " + option.value;
}

std::string help_of(const Declaration& all, const DeclaredCommand& command) {
  return full_name(all, command) + " --help";
}

}  // namespace

UsageError missing_command(const Declaration& all, const DeclaredCommand& group) {
  return {group.name.empty() ? "no command is given" : "no command after " + full_name(all, group),
          help_of(all, group) + " lists the commands"};
}

UsageError unknown_command(const Declaration& all, const DeclaredCommand& group, const std::string& typed) {
  std::vector<std::string> known;
  for (const DeclaredCommand* one : commands_of(all, group)) known.push_back(base_name(*one));
  for (const DeclaredOption& option : group.options) known.push_back(option.name());  // "help" means "--help"
  const std::string place = group.name.empty() ? "" : group.name + " ";
  const auto meant = nearest(typed, known);
  return {"there is no command '" + place + one_line(typed, kTypedBytes) + "'",
          meant ? "did you mean " + (meant->front() == '-' ? *meant : place + *meant) + "?"
                : help_of(all, group) + " lists the commands"};
}

UsageError unknown_option(const Declaration& all, const DeclaredCommand& command, const std::string& typed) {
  std::vector<std::string> known;
  for (const DeclaredOption& option : command.options) known.push_back(option.name());
  const std::string shown = option_word(typed);
  const auto meant = nearest(shown, known);
  const std::string place = command.name.empty() ? "there is no option " : command.name + " has no option ";
  return {place + shown, meant ? "did you mean " + *meant + "?" : help_of(all, command) + " lists the options"};
}

UsageError option_before_command(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option) {
  return {option.name() + " stands before the command",
          "give it after: " + full_name(all, command) + " " + form(option)};
}

UsageError extra_argument(const Declaration& all, const DeclaredCommand& command, const std::string& typed) {
  if (command.arguments.empty()) {
    return {command.name + " takes options only, and " + typed_word(typed) + " is not one",
            help_of(all, command) + " lists the options"};
  }
  return {
      command.name + " takes one " + command.arguments.front().name() + ", and " + typed_word(typed) + " is another",
      "omit one"};
}

UsageError missing_option(const Declaration& all, const DeclaredCommand& command, const DeclaredOption& option) {
  const bool is_argument = option.name().front() != '-';
  const std::string what = option.choices.empty() || !is_argument ? "" : ": " + one_of_these(option.choices);
  return {(is_argument ? "no " : command.name + " needs ") + option.name(),
          "give " + full_name(all, command) + " " + form(option) + what};
}

OptionError missing_value(const DeclaredOption& option) {
  return {{option_id(option.name())}, "has no value", "give " + option.value};
}

UsageError flag_with_value(const DeclaredOption& option) {
  return {option.name() + " takes no value", "give it alone, or omit it"};
}

OptionError given_twice(const DeclaredOption& option) {
  return {{option_id(option.name())}, "is given twice", "keep one"};
}

OptionError wrong_value(const DeclaredOption& option, const std::string& typed) {
  const auto meant = nearest(typed, option.choices);
  const std::string remedy = meant                    ? "did you mean " + *meant + "?"
                             : option.choices.empty() ? "give " + option.requirement
                                                      : "give " + one_of_these(option.choices);
  return OptionError::wrong_value(option_id(option.name()), typed, remedy);
}

}  // namespace percuss::tools
