#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/chart_mark.hpp"

namespace percuss {

/// One line of a chart: its name, written at its end, and its points in the order of x; NaN breaks the line.
struct ChartCurve {
  std::string name;
  std::vector<double> x, y;
  bool marks = false;  // the points themselves as well
  bool line = true;    // false: the points alone, in any order
  ChartMark mark = ChartMark::circle;
  std::optional<std::size_t> style;  // colour and dashes: its place among the curves unless given
  std::vector<std::string> labels;   // beside the points, as far as there are any
};

struct ChartAxis {
  std::string label;         // with its unit: "hoop frequency, Hz"
  bool logarithmic = false;  // all values above zero
};

struct LineChart {
  std::string title;
  ChartAxis x, y;
  std::vector<ChartCurve> curves;
};

/// The chart as a document of its own (SVG 1.1): ticks at round numbers, colours that stay apart for the colour-blind
/// and dashes that stay apart in print, text of 12 px and more. At most a thousand points of a line are drawn: the
/// extremes of its neighbours stand for the others. Where a curve is points alone, the names stand in a legend.
std::string line_chart_svg(const LineChart& chart);

/// Round numbers (1, 2 or 5 times a power of ten apart) that cover low to high with about `wanted` steps, those inside
/// only.
std::vector<double> round_ticks(double low, double high, std::size_t wanted);

}  // namespace percuss
