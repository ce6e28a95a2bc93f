#pragma once
#include <string>
#include <vector>

#include "report/columns.hpp"
#include "report/line_chart.hpp"

namespace percuss {

/// What a model's command has to show, in each of the forms it may be asked for.
struct ModelReport {
  std::string json;                   // the document
  std::string text;                   // for the terminal
  std::vector<NumberColumn> columns;  // for .csv
  LineChart chart;                    // for .svg
};

}  // namespace percuss
