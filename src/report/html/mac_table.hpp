#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/html/command_report.hpp"

namespace percuss::report {

/// A MAC matrix as an HTML table: numbers on shades in five steps, 0 … 0.2 … 1. Rows and columns are named; a dash
/// stands for shapes with fewer than three common places. Texts are escaped.
std::string mac_table_html(const MacMatrix& matrix);

}  // namespace percuss::report
