#pragma once
#include <string>
#include <vector>

namespace percuss::report {

/// A column of a table of numbers: its name with the unit ("hoop_hz"), and a value per row; NaN where there is none.
struct NumericColumn {
  std::string name;
  std::vector<double> values;
};

/// The table as CSV: names first, then a line per row; nothing between the commas where there is no value. Numbers are
/// the shortest that read back as the same. shapes: every column alike long.
std::string numeric_csv(const std::vector<NumericColumn>& columns);

}  // namespace percuss::report
