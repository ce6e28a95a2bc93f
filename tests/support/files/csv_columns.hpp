#pragma once
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/percuss_process.hpp"
#include "support/scratch_folder.hpp"

namespace percuss::test {

/// The columns of a CSV file by name; NaN for cells without a number. No cell may contain a comma.
inline std::map<std::string, std::vector<double>> csv_columns(const std::string& path) {
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (!line.empty() && line.back() == ',') cells.emplace_back();
    return cells;
  };
  const std::vector<std::string> lines = lines_of(bytes_of(path));
  std::map<std::string, std::vector<double>> out;
  const std::vector<std::string> names = cells_of(lines.at(0));
  for (std::size_t row = 1; row < lines.size(); ++row) {
    const std::vector<std::string> cells = cells_of(lines[row]);
    for (std::size_t c = 0; c < names.size(); ++c) {
      char* end = nullptr;
      const double value = std::strtod(cells.at(c).c_str(), &end);
      out[names[c]].push_back(end == cells[c].c_str() ? std::numeric_limits<double>::quiet_NaN() : value);
    }
  }
  return out;
}

}  // namespace percuss::test
