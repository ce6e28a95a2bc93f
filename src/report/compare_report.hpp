#pragma once
#include <string>
#include <vector>

#include "metrics/compare.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/compare/1. Compares each document with the first: modes and deflections side by side. Table: a row
/// per mode of the first document, with the frequency in each document and its difference from the first; then a row
/// per position at which the first two documents have a deflection. Chart: deflections over position if there are any,
/// else frequencies relative to the first document. Needs two documents or more.
CommandReport compare_report(const std::vector<metrics::ComparedDocument>& documents,
                             const metrics::PairOptions& options = {});

}  // namespace percuss::report
