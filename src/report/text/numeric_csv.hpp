#pragma once
#include <string>
#include <vector>

#include "core/io/csv_cell.hpp"

namespace percuss::report {

/// A column of a table of numbers: its name with the unit ("hoop_hz"), and a value per row; NaN where there is none.
struct NumericColumn {
  std::string name;
  std::vector<double> values;
};

/// A column of words, such as names of bats, and one word per row; may be empty.
struct WordColumn {
  std::string name;
  std::vector<std::string> values;
};

/// The table as CSV: names first, then a line per row; an empty field where there is no value. Numbers have the fewest
/// digits that read back as the same number. shapes: all columns have the same length.
std::string numeric_csv(const std::vector<NumericColumn>& columns);

/// As above, with columns of words after the numbers. Words are escaped as `formulas` says.
std::string numeric_csv(const std::vector<NumericColumn>& columns, const std::vector<WordColumn>& words,
                        CsvFormulas formulas);

}  // namespace percuss::report
