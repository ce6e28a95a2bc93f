#include "cli/help_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kColumn = 28;  // column of the help texts
constexpr std::size_t kMaxWidth = 120;

// "  --band LO:HI             Analyse …"; the help text starts on its own line if the left part is long.
std::string entry(const std::string& left, const std::string& right, std::size_t width) {
  std::string out = "  " + left;
  const std::size_t used = report::text_width(out);
  out += used + 2 > kColumn ? "\n" + std::string(kColumn, ' ') : std::string(kColumn - used, ' ');
  return out + report::wrapped(right, width, kColumn) + "\n";
}

std::string option_entry(const DeclaredOption& option, std::size_t width) {
  const std::string value = option.value.empty() ? "" : " " + option.value;
  return entry(fmt::format("{}{}", fmt::join(option.names, ", "), value), option_help_text(option), width);
}

std::string usage_lines(const Declaration& all, const DeclaredCommand& command, std::size_t width) {
  constexpr std::size_t kIndent = 7;  // of "Usage: "
  return "Usage: " + report::wrapped(fmt::format("{}", fmt::join(usage_of(all, command), " ")), width, kIndent) + "\n";
}

std::string examples_of(const DeclaredCommand& command, std::size_t width) {
  std::string out = command.examples.empty() ? "" : "\nExamples:\n";
  for (const DeclaredExample& example : command.examples) {
    constexpr std::size_t kIndent = 6;
    out += "  " + example.line + "\n";  // never wrapped, so that it can be copied
    if (!example.meaning.empty())
      out += std::string(kIndent, ' ') + report::wrapped(example.meaning, width, kIndent) + "\n";
  }
  return out;
}

}  // namespace

std::string help_text(const Declaration& all, const DeclaredCommand& command, std::size_t width) {
  width = std::min(width, kMaxWidth);
  std::string out = command.summary + "\n\n" + usage_lines(all, command, width);
  if (!command.about.empty()) out += "\n" + report::wrapped(command.about, width, 0) + "\n";
  const auto below = commands_of(all, command);
  if (!below.empty()) out += "\nCommands:\n";
  for (const DeclaredCommand* one : below) out += entry(base_name(*one), one->summary, width);
  if (!command.arguments.empty()) out += "\nArguments:\n";
  for (const DeclaredOption& argument : command.arguments)
    out += entry(argument.name() + (argument.repeatable ? "..." : ""), option_help_text(argument), width);
  for (const OptionGroup& group : groups_of(command)) {
    out += "\n" + (group.heading.empty() ? "Options" : group.heading) + ":\n";
    for (const DeclaredOption* option : group.options) out += option_entry(*option, width);
  }
  return out + examples_of(command, width);
}

}  // namespace percuss::tools
