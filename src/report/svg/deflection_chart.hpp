#pragma once
#include <optional>

#include "pipeline/impact_test.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// Deflection over time. Several struck points: a curve for each point and channel, up to 24 curves, from the hit whose
/// peak is nearest to the mean of the point's hits. One point: the 12 curves (hit and channel) with the largest peaks.
/// Bands of one standard deviation where it is known. A curve ends where its standard deviation exceeds half the peak,
/// so that late drift does not set the scale. The title then says so.
LineChart deflection_chart(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

/// Mean largest deflection of each point over its position, with a band of one standard deviation; none if fewer than
/// two points have a position.
std::optional<LineChart> deflection_over_position(const pipeline::Analysis& analysis, const pipeline::ImpactTest& test);

}  // namespace percuss::report
