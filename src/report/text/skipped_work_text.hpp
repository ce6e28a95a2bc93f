#pragma once
#include "pipeline/analysis.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// What an analysis did not have to do, how much of it, and why.
ReportText skipped_text(const pipeline::Analysis& analysis);

}  // namespace percuss::report
