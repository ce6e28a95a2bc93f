#pragma once
#include <string>

#include "pipeline/impact_test.hpp"
#include "report/text/report_text.hpp"

namespace percuss::report {

/// The deflections as tables, after the name of the file.
ReportText deflection_text(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);
/// The tables and warnings alone.
ReportText deflection_tables(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// Time of a sample of the hit, from the row's beginning.
double sample_time_s(const pipeline::Analysis& analysis, const pipeline::DeflectedHit& hit, std::size_t sample);

}  // namespace percuss::report
