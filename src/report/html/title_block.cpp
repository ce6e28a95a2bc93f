#include "report/html/title_block.hpp"

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "report/text/html_escape.hpp"

namespace percuss::report {
namespace {

constexpr std::size_t kMaxText_bytes = 1000;    // of one row
constexpr std::size_t kMaxLine_bytes = 20'000;  // of the note

std::string row_html(const std::string& what, const std::string& text) {
  if (text.empty()) return "";
  return "<dt>" + html_escape(what) + "</dt><dd>" + html_escape(one_line(text, kMaxText_bytes)) + "</dd>\n";
}

// Paragraphs between empty lines; line ends within a paragraph stay.
std::string note_html(const std::string& note) {
  std::istringstream lines(note);
  lines.exceptions(std::ios::badbit);  // else a failed allocation would end the text
  std::string out, paragraph;
  const auto close = [&] {
    if (!paragraph.empty()) out += "<p>" + paragraph + "</p>\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (line.find_first_not_of(' ') == std::string::npos) {
      close();
    } else {
      paragraph += (paragraph.empty() ? "" : "<br>") + html_escape(one_line(line, kMaxLine_bytes));
    }
  }
  close();
  return out.empty() ? "" : "<div class=\"note\">\n" + out + "</div>\n";
}

}  // namespace

std::string page_header(const std::string& name, const std::string& conditions, const TitleBlock& block) {
  const std::string title = block.title.empty() ? name : one_line(block.title, kMaxText_bytes);
  std::string rows = row_html("Customer", block.customer) + row_html("Specimen", block.specimen) +
                     row_html("Operator", block.operator_name) + row_html("Date of the test", block.date);
  for (const auto& [what, text] : block.facts) rows += row_html(what, text);
  if (!block.title.empty()) rows += row_html("Record", name);
  const std::string logo =
      block.logo.empty() ? "" : R"(<img class="logo" alt="Logo" src=")" + html_escape(block.logo) + "\">\n";
  const std::string shown_conditions =
      conditions.empty() ? "" : "<p class=\"conditions\">" + html_escape(conditions) + "</p>\n";
  return "<header>\n" + logo + "<h1>" + html_escape(title) + "</h1>\n" + shown_conditions +
         (rows.empty() ? "" : "<dl class=\"facts\">\n" + rows + "</dl>\n") + note_html(block.note) + "</header>\n";
}

}  // namespace percuss::report
