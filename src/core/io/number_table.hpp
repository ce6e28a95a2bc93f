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
  std::size_t columns = 2;      // in every line; the minimum if max_columns is above it
  std::size_t max_columns = 0;  // if above `columns`: every line has as many as the first, and at most this many
  std::size_t max_rows = 10'000;
  std::string remedy;  // for messages: describes the expected lines
};

/// A table of numbers with the lines of names before it.
struct NumberTable {
  std::vector<std::vector<std::string>> headers;  // the cells of each line of names, UTF-8, without blanks around them
  std::vector<NumberTableRow> rows;
};

/// Reads a text of numbers, with delimiters, quotes, comments and decimal marks as in records. Lines of names may come
/// first. `path` as in read_input.
/// errors  InputError with file and line: no numbers, a cell without a finite number, too few or too many cells, too
/// many lines, too many bytes
NumberTable read_named_number_table(const std::string& path, const NumberTableSpec& wanted);

/// As read_named_number_table, for a text in memory; `where` names it.
NumberTable parse_named_number_table(std::string_view text, const std::string& where, const NumberTableSpec& wanted);

/// The rows of parse_named_number_table.
std::vector<NumberTableRow> parse_number_table(std::string_view text, const std::string& where,
                                               const NumberTableSpec& wanted);

}  // namespace core
}  // namespace percuss
