#pragma once
#include <string>
#include <vector>

#include "metrics/compare.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/compare/1: every document against the first, modes and deflections side by side; the table's columns are the
/// documents, its rows the modes of the first, then the places of its deflections. The chart: deflections over position
/// where there are any, else the frequencies against the first document's. At least two documents.
CommandReport compare_report(const std::vector<metrics::ComparedDocument>& documents,
                             const metrics::PairOptions& options = {});

}  // namespace percuss::report
