#pragma once
#include <optional>

#include "metrics/study/study.hpp"
#include "metrics/study/study_join.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/study/1 (docs/schema/study.schema.json); the statements with their statistics, then the outliers; the
/// statistics of every class of every figure as one table; every figure and every bat's trail, with `curve` over those
/// of the hoop frequency.
CommandReport study_report(const metrics::Study& study, const std::optional<metrics::StudyCurve>& curve = {});

}  // namespace percuss::report
