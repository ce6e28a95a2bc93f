#pragma once
#include <string>

#include "cli/command_line.hpp"
#include "report/html/title_block.hpp"

namespace percuss::tools {

/// The options of the title block of a page, as typed.
struct TitleFlags {
  std::string title, customer, operator_name, specimen, date;
  std::string note;  // a text, or @FILE
  std::string logo;  // a file
  std::string paper = "a4";

  bool given() const;
};

void add_title_flags(Command& command, TitleFlags& flags);

/// Sets the flag that `name` ("title", …, "paper") names.
/// errors  OptionError: a paper that add_title_flags() does not offer. std::out_of_range: an unknown name.
void set_title_flag(TitleFlags& flags, const std::string& name, const std::string& value);

/// The title block, with the files of the note and the logo read.
/// errors  InputError: a file that cannot be read, or is no picture; OptionError: a text that is too long
report::TitleBlock title_block(const TitleFlags& flags);

}  // namespace percuss::tools
