#pragma once
#include <string>

namespace percuss::metrics {

/// A text as a CSV cell: quoted where it contains a separator (comma, semicolon, tab), a quote or a line end.
std::string csv_cell(const std::string& text);

}  // namespace percuss::metrics
