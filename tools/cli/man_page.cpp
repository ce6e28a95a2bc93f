#include "cli/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "report/text/text_table.hpp"

namespace percuss::tools {
namespace {

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
};

// The first character of a UTF-8 text.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  std::uint32_t code = bytes == 1 ? lead : lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < std::min(bytes, text.size()); ++i) code = (code << 6U) | (byte(i) & 0x3fU);
  return {code, std::min(bytes, text.size())};
}

// Text escaped for roff, so that no word becomes a request at the start of a line, and typed characters such as - and '
// stay ASCII.
std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const auto [code, bytes] = first_of(text);
    if (code == '.' && (out.empty() || out.back() == ' ')) out += R"(\&)";
    switch (code) {
      case '\\':
        out += R"(\e)";
        break;
      case '-':
        out += R"(\-)";
        break;
      case '\'':
        out += R"(\(aq)";
        break;
      case '"':
        out += R"(\(dq)";
        break;
      case '`':
        out += R"(\(ga)";
        break;
      case '^':
        out += R"(\(ha)";
        break;
      case '~':
        out += R"(\(ti)";
        break;
      default:
        out += code < 0x80 ? std::string(1, static_cast<char>(code)) : fmt::format(R"(\[u{:04X}])", code);
    }
    text.remove_prefix(bytes);
  }
  return out;
}

std::string paragraph(const std::string& text) {
  constexpr std::size_t kWidth = 78;
  return report::wrapped(escaped(text), kWidth, 0) + "\n";
}

std::string bold(std::string_view text) { return R"(\fB)" + escaped(text) + R"(\fR)"; }
std::string italic(std::string_view text) { return R"(\fI)" + escaped(text) + R"(\fR)"; }

std::string section(std::string_view name) { return fmt::format(".SH {}\n", name); }

// roff requires its own dash in "name - summary".
std::string name_line(const Declaration& all, const DeclaredCommand& command) {
  return escaped(page_name(all, command)) + " \\-\n" + paragraph(command.summary);
}

// Bold for literal words, italic for placeholders: "percuss calibrate --mass KG [OPTION]... [FILE...]".
std::string synopsis(const Declaration& all, const DeclaredCommand& command) {
  std::string out = section("SYNOPSIS");
  for (const std::string& part : usage_of(all, command)) {
    const bool typed = part == full_name(all, command);
    const std::size_t blank = part.starts_with('-') ? part.find(' ') : std::string::npos;
    out += (typed                        ? bold(part)
            : blank == std::string::npos ? italic(part)
                                         : bold(part.substr(0, blank)) + " " + italic(part.substr(blank + 1))) +
           "\n";
  }
  return out;
}

std::string item(const std::string& head, const std::string& text) { return ".TP\n" + head + "\n" + paragraph(text); }

std::string description(const Declaration& all, const DeclaredCommand& command) {
  std::string out = section("DESCRIPTION") + paragraph(command.about.empty() ? command.summary + "." : command.about);
  for (const DeclaredCommand* one : commands_of(all, command)) out += item(bold(base_name(*one)), one->summary);
  for (const DeclaredOption& argument : command.arguments)
    out += item(italic(argument.name() + (argument.repeatable ? "..." : "")), option_help_text(argument));
  return out;
}

std::string options(const DeclaredCommand& command) {
  std::string out = section("OPTIONS");
  for (const OptionGroup& group : groups_of(command)) {
    if (!group.heading.empty()) out += ".SS " + escaped(group.heading) + "\n";
    for (const DeclaredOption* option : group.options) {
      std::string head;
      for (const std::string& name : option->names) head += (head.empty() ? "" : ", ") + bold(name);
      out += item(option->value.empty() ? head : head + " " + italic(option->value), option_help_text(*option));
    }
  }
  return out;
}

std::string examples(const DeclaredCommand& command) {
  if (command.examples.empty()) return "";
  std::string out = section("EXAMPLES");
  bool first = true;
  for (const DeclaredExample& example : command.examples) {
    if (!first) out += ".PP\n";
    first = false;
    if (!example.meaning.empty()) out += paragraph(example.meaning + ":") + ".PP\n";
    out += ".RS 4\n.nf\n" + escaped(example.line) + "\n.fi\n.RE\n";
  }
  return out;
}

std::string exit_status(const Declaration& all) {
  std::string out = section("EXIT STATUS");
  for (const DeclaredExit& exit : all.exits) out += item(bold(std::to_string(exit.code)), exit.meaning);
  return out;
}

// The pages of the parents, siblings and subcommands.
std::string see_also(const Declaration& all, const DeclaredCommand& command) {
  std::vector<std::string> pages;
  for (const DeclaredCommand& one : all.commands) {
    const bool above = !command.name.empty() && (one.name.empty() || command.name.starts_with(one.name + " "));
    const bool group = command.is_group && (command.name.empty() || one.name.starts_with(command.name + " "));
    const std::size_t blank = command.name.rfind(' ');
    const bool beside = blank != std::string::npos && one.name.starts_with(command.name.substr(0, blank + 1));
    const bool top = !command.name.empty() && blank == std::string::npos && one.name.find(' ') == std::string::npos;
    if (&one != &command && (above || group || beside || top))
      pages.push_back(R"(\%)" + bold(page_name(all, one)) + "(1)");
  }
  return section("SEE ALSO") + fmt::format("{}\n", fmt::join(pages, ",\n"));
}

}  // namespace

std::string page_name(const Declaration& all, const DeclaredCommand& command) {
  std::string name = full_name(all, command);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string man_page(const Declaration& all, const DeclaredCommand& command) {
  std::string title = page_name(all, command);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return fmt::format(".TH {} 1 \"\" \"{} {}\" \"User commands\"\n", escaped(title), all.program, all.version) +
         section("NAME") + name_line(all, command) + synopsis(all, command) + description(all, command) +
         options(command) + examples(command) + exit_status(all) + see_also(all, command);
}

}  // namespace percuss::tools
