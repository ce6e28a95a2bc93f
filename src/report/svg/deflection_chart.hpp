#pragma once
#include <optional>

#include "pipeline/impact_test.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// Deflection over time. Several struck points: one hit of each point, the one nearest to the mean of its repeats, for
/// up to two dozen points and channels together. One point: the dozen hits with the largest peaks.
LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// Mean largest deflection of each point over its position, with a band of one standard deviation; none if fewer than
/// two points have a position.
std::optional<LineChart> deflection_over_position(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

}  // namespace percuss::report
