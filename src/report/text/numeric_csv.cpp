#include "report/text/numeric_csv.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>

namespace percuss::report {

std::string numeric_csv(const std::vector<NumericColumn>& columns) {
  return numeric_csv(columns, {}, CsvFormulas::neutralise);
}

std::string numeric_csv(const std::vector<NumericColumn>& columns, const std::vector<WordColumn>& words,
                        CsvFormulas formulas) {
  std::string text;
  for (const NumericColumn& column : columns) text += (text.empty() ? "" : ",") + column.name;
  for (const WordColumn& column : words) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      assert(columns[c].values.size() == rows);
      if (c > 0) text += ',';
      const double value = columns[c].values[row];
      if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
    for (const WordColumn& column : words) {
      assert(column.values.size() == rows);
      text += "," + csv_cell(column.values[row], formulas);
    }
    text += '\n';
  }
  return text;
}

}  // namespace percuss::report
