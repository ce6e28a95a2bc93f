#pragma once
#include "pipeline/impact_test.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// Deflection over time, for the dozen hits with the largest peaks.
LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

}  // namespace percuss::report
