#pragma once
#include <string>
#include <utility>
#include <vector>

#include "report/json/bending_plot.hpp"
#include "report/json/mac_matrix.hpp"
#include "report/svg/line_chart.hpp"
#include "report/text/numeric_csv.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// The results of a command in each output format.
struct CommandReport {
  std::string json;                                          // the document
  ReportText text;                                           // for the terminal, and for the page
  std::vector<std::pair<std::string, std::string>> facts{};  // at the head of the page: what, text
  std::vector<NumericColumn> columns;                        // for .csv
  std::vector<WordColumn> words;                             // after `columns` in .csv
  CsvFormulas formulas = CsvFormulas::neutralise;
  std::string table;              // in place of `columns` in .csv, for a table that contains words
  std::vector<LineChart> charts;  // for .svg, and for the page
  BendingPlot bending;            // for the page
  std::vector<MacMatrix> macs;    // for the page

  std::string csv() const { return table.empty() ? numeric_csv(columns, words, formulas) : table; }
};

}  // namespace percuss::report
