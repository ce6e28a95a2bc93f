#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {
inline namespace core {

/// A line of a small table of numbers, with its place for messages.
struct NumberTableRow {
  std::string place;  // "bat.dat: line 12"
  std::vector<double> values;
};

/// The required form of such a table.
struct NumberTableSpec {
  std::size_t columns = 2;  // in every line
  std::size_t max_rows = 10'000;
  std::string remedy;  // for messages: describes the expected lines
};

/// Reads a text of numbers, with delimiters, quotes, comments and decimal marks as in records. Lines of names may come
/// first. `path` as in read_input.
/// errors  InputError with file and line: no numbers, a cell without a finite number, too few or too many cells, too
/// many lines, too many bytes
std::vector<NumberTableRow> read_number_table(const std::string& path, const NumberTableSpec& wanted);

/// As read_number_table, for a text in memory; `where` names it.
std::vector<NumberTableRow> parse_number_table(std::string_view text, const std::string& where,
                                               const NumberTableSpec& wanted);

}  // namespace core
}  // namespace percuss
