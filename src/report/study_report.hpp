#pragma once
#include <optional>

#include "metrics/study/study.hpp"
#include "metrics/study/study_files.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/study/1 (docs/schema/study.schema.json). Text: the statements with their statistics, then the
/// outliers and the descriptive numbers of each group. Table: the statistics of each class of each figure. Charts: each
/// figure and the history of each bat with several states. `curve` is drawn in the charts over the hoop frequency.
CommandReport study_report(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {},
                           CsvFormulas formulas = CsvFormulas::neutralise);

}  // namespace percuss::report
