#pragma once
#include <string>
#include <vector>

#include "metrics/compare.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/compare/1. Compares each document with the first: modes and deflections side by side. Table: a column
/// per document, a row per mode of the first, then per position of its deflections. Chart: deflections over position if
/// there are any, else frequencies relative to the first document. Needs two documents or more.
CommandReport compare_report(const std::vector<metrics::ComparedDocument>& documents,
                             const metrics::PairOptions& options = {});

}  // namespace percuss::report
