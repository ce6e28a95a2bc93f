#include "cli/title_flags.hpp"

#include <fmt/format.h>

#include <map>

#include "cli/option_error.hpp"
#include "core/io/input_file.hpp"
#include "report/html/logo.hpp"

namespace percuss::tools {
namespace {

constexpr std::size_t kMaxLine_bytes = 500, kMaxNote_bytes = 20'000;

const std::string& checked(const OptionId& option, const std::string& text) {
  if (text.size() > kMaxLine_bytes) {
    throw OptionError({option}, fmt::format("has {} bytes", text.size()),
                      fmt::format("give {} at most", kMaxLine_bytes));
  }
  return text;
}

std::string note_of(const std::string& typed) {
  if (typed.starts_with("@")) return std::string(read_input(typed.substr(1), kMaxNote_bytes).view());
  if (typed.size() <= kMaxNote_bytes) return typed;
  throw OptionError({"note"}, fmt::format("has {} bytes", typed.size()),
                    fmt::format("give {} at most", kMaxNote_bytes));
}

std::string logo_of(const std::string& path) { return path.empty() ? "" : report::logo_of_file(path); }

}  // namespace

bool TitleFlags::given() const {
  return !(title + customer + operator_name + specimen + date + note + logo).empty() || paper != TitleFlags{}.paper;
}

void set_title_flag(TitleFlags& flags, const std::string& name, const std::string& value) {
  static const std::map<std::string, std::string TitleFlags::*> members{{"title", &TitleFlags::title},
                                                                        {"customer", &TitleFlags::customer},
                                                                        {"operator", &TitleFlags::operator_name},
                                                                        {"specimen", &TitleFlags::specimen},
                                                                        {"date", &TitleFlags::date},
                                                                        {"note", &TitleFlags::note},
                                                                        {"logo", &TitleFlags::logo},
                                                                        {"paper", &TitleFlags::paper}};
  if (name == "paper" && value != "a4" && value != "letter")
    throw OptionError::wrong_value("paper", value, "choose a4 or letter");
  flags.*members.at(name) = value;
}

void add_title_flags(Command& command, TitleFlags& flags) {
  const std::string previous = command.heading("Page");
  command.value("--title", flags.title, "Set the title of the page (default: the name of the file)").type("TEXT");
  command.value("--customer", flags.customer, "State the customer on the page").type("TEXT");
  command.value("--operator", flags.operator_name, "State on the page who did the test").type("TEXT");
  command.value("--specimen", flags.specimen, "State on the page what was tested").type("TEXT");
  command.value("--date", flags.date, "State on the page when the test was done (default: as the file states it)")
      .type("TEXT");
  command.value("--note", flags.note, "Put this text, or the text of a file, at the top of the page")
      .type("TEXT|@FILE");
  command.value("--logo", flags.logo, "Put this picture at the top of the page (PNG, JPEG or SVG, at most 200 kB)")
      .type("FILE");
  command.value("--paper", flags.paper, "Set the paper on which the page is printed")
      .one_of({"a4", "letter"})
      .show_default();
  command.heading(previous);
}

report::TitleBlock title_block(const TitleFlags& flags) {
  report::TitleBlock block{.title = checked("title", flags.title),
                           .customer = checked("customer", flags.customer),
                           .operator_name = checked("operator", flags.operator_name),
                           .specimen = checked("specimen", flags.specimen),
                           .date = checked("date", flags.date),
                           .note = note_of(flags.note),
                           .logo = logo_of(flags.logo),
                           .facts = {}};
  if (flags.paper == "letter") {
    block.paper = report::kLetterPaper.name;
    block.print_width = report::kLetterPaper.print_width;
  }
  return block;
}

}  // namespace percuss::tools
