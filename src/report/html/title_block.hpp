#pragma once
#include <string>
#include <utility>
#include <vector>

namespace percuss::report {

/// The user's statements on a page, as plain text. Empty members are left out.
struct TitleBlock {
  std::string title;  // in place of the file's name
  std::string customer;
  std::string operator_name;
  std::string specimen;
  std::string note;                 // lines, and paragraphs between empty lines
  std::string logo;                 // a picture as a data URI (logo_data_uri), or empty
  std::string paper = "A4";         // the page's paper in print, a CSS page size
  std::string print_width = "680";  // of the plots in print, CSS px: the paper without its margins
  std::vector<std::pair<std::string, std::string>> facts;  // further rows: what, text
};

/// The head of a page: logo, title, conditions of the test, the statements as rows, and the note. `name` is the title
/// where the user gives none, and a row otherwise.
std::string page_header(const std::string& name, const std::string& conditions, const TitleBlock& block);

}  // namespace percuss::report
