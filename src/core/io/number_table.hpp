#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss::inline core {

/// A line of a small table of numbers, and where it stood, for messages about what the numbers mean.
struct NumberTableRow {
  std::string place;  // "bat.dat: line 12"
  std::vector<double> values;
};

/// What is wanted of such a table.
struct NumberTableSpec {
  std::size_t columns = 2;  // that every line must have, neither more nor fewer
  std::size_t max_rows = 10'000;
  std::string remedy;  // the end of messages: what the lines should be
};

/// Reads a text of numbers: delimiters, quotes, comments and decimal marks as in records; lines of names may come
/// first. `path` as in read_input. errors  InputError with file and line: no numbers, a cell that is none or is not
/// finite, too few or too many cells, too many lines, too long.
std::vector<NumberTableRow> read_number_table(const std::string& path, const NumberTableSpec& wanted);

/// As read_number_table, for a text in memory; `where` names it.
std::vector<NumberTableRow> parse_number_table(std::string_view text, const std::string& where,
                                               const NumberTableSpec& wanted);

}  // namespace percuss::inline core
