#include "report/text/numeric_csv.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>

namespace percuss::report {

std::string numeric_csv(const std::vector<NumericColumn>& columns) {
  std::string text;
  for (const NumericColumn& column : columns) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      assert(columns[c].values.size() == rows);
      if (c > 0) text += ',';
      const double value = columns[c].values[row];
      if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace percuss::report
