#pragma once
#include <string>
#include <vector>

#include "report/svg/chart_scale.hpp"
#include "report/svg/line_chart.hpp"

namespace percuss::report {

/// The scales of a chart's two axes.
struct ChartPlane {
  const ChartScale& x;
  const ChartScale& y;
};

/// SVG path through x and y, interrupted at gaps. Where y is beyond the range of its axis, the path follows the plot's
/// border.
std::string path_through(const ChartPlane& plane, const std::vector<double>& x, const std::vector<double>& y);

/// SVG path around the area between the band's curves. Gaps of either curve divide it into parts, each closed.
std::string path_around(const ChartPlane& plane, const ChartBand& band);

}  // namespace percuss::report
