#pragma once
#include <vector>

#include "pipeline/warnings/warning.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// One paragraph per warning.
ReportText warnings_text(const std::vector<pipeline::Warning>& warnings);

}  // namespace percuss::report
