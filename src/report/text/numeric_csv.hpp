#pragma once
#include <string>
#include <vector>

namespace percuss::report {

/// A column of a table of numbers: its name with the unit ("hoop_hz"), and a value per row; NaN where there is none.
struct NumericColumn {
  std::string name;
  std::vector<double> values;
};

/// The table as CSV: names first, then a line per row; an empty field where there is no value. Numbers have the fewest
/// digits that read back as the same number. shapes: all columns have the same length.
std::string numeric_csv(const std::vector<NumericColumn>& columns);

}  // namespace percuss::report
