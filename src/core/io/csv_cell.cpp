#include "core/io/csv_cell.hpp"

#include <algorithm>

#include "core/io/parse_number.hpp"

namespace percuss {
inline namespace core {
namespace {

// Whether a spreadsheet would take the text without its leading apostrophes for a formula.
bool begins_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
}

}  // namespace

std::string csv_cell(const std::string& text, CsvFormulas formulas) {
  const bool computed = formulas == CsvFormulas::neutralise && begins_formula(text) &&
                        parse_number(text, false).problem != NumberProblem::none;
  if (computed) return csv_cell("'" + text, CsvFormulas::keep);
  if (text.find_first_of(",;\t\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string text_of_csv_cell(std::string_view cell) {
  if (cell.starts_with('\'') && begins_formula(cell)) cell.remove_prefix(1);
  std::string out;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    out += cell[i];
    if (cell.substr(i).starts_with("\"\"")) ++i;
  }
  return out;
}

}  // namespace core
}  // namespace percuss
