#pragma once
#include <optional>
#include <string>
#include <vector>

namespace percuss::report {

/// Modal assurance criteria between two sets of modes, with names such as "205.0 Hz".
struct MacMatrix {
  std::string caption;
  std::vector<std::string> rows, columns;
  std::vector<std::vector<std::optional<double>>> values;  // [rows][columns]; nothing: fewer than three common places
};

}  // namespace percuss::report
