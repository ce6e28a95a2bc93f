#pragma once
#include <string>
#include <utility>
#include <vector>

namespace percuss::report {

/// A paper for print. Plots fill its width less 15 mm on each side, the margin in paper_style() of html_page.cpp.
struct PrintPaper {
  const char* name;         // a CSS page size
  const char* print_width;  // of the plots, CSS px of 25.4/96 mm
};
inline constexpr PrintPaper kA4Paper{.name = "A4", .print_width = "680"};
inline constexpr PrintPaper kLetterPaper{.name = "letter", .print_width = "702"};

/// The user's statements on a page, as plain text. Empty members are left out.
struct TitleBlock {
  std::string title;  // in place of the file's name
  std::string customer;
  std::string operator_name;
  std::string specimen;
  std::string date;  // of the test, in place of the date that the file states
  std::string note;  // lines, and paragraphs between empty lines
  std::string logo;  // a picture as a data URI (logo_data_uri), or empty
  std::string paper = kA4Paper.name;
  std::string print_width = kA4Paper.print_width;
  std::vector<std::pair<std::string, std::string>> facts;  // further rows: what, text
};

/// The head of a page: logo, title, conditions of the test, the statements as rows, and the note. `name` is the title
/// where the user gives none, and a row otherwise.
std::string page_header(const std::string& name, const std::string& conditions, const TitleBlock& block);

}  // namespace percuss::report
