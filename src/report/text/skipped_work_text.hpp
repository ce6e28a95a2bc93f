#pragma once
#include "pipeline/analysis.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// The work that an analysis skipped: how much of it, and why.
ReportText skipped_text(const pipeline::Analysis& analysis);

}  // namespace percuss::report
