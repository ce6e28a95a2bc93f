#pragma once
#include <string>
#include <string_view>

namespace percuss {
inline namespace core {

/// The form of a text that a spreadsheet would take for a formula: with a leading apostrophe, or unchanged.
enum class CsvFormulas { neutralise, keep };

/// A text as a CSV cell: quoted where it contains a separator (comma, semicolon, tab), a quote or a line end. A text
/// that begins with = + - @, a tab or a line end, and is not a number, gets a leading apostrophe, unless formulas are
/// kept. A text with apostrophes before such a character gets one more, so that text_of_csv_cell() restores every text.
std::string csv_cell(const std::string& text, CsvFormulas formulas = CsvFormulas::neutralise);

/// The text of a cell without the apostrophe and the second quotes that csv_cell() added. The quotes around the cell
/// are gone already (split_cells).
std::string text_of_csv_cell(std::string_view cell);

}  // namespace core
}  // namespace percuss
