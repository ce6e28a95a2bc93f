#pragma once
#include <string>

namespace percuss::metrics {

/// A text as a cell of a table: quoted where it holds a comma, a quote or a line's end.
std::string csv_cell(const std::string& text);

}  // namespace percuss::metrics
