#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/svg/chart_mark.hpp"
#include "report/svg/svg_fragment.hpp"

namespace percuss::report {

/// One curve of a chart: its name, written at its end, and its points in the order of x. NaN breaks the line.
struct ChartCurve {
  std::string name;
  std::vector<double> x, y;
  bool marks = false;  // also marks the points
  bool line = true;    // false: points alone, in any order
  ChartMark mark = ChartMark::circle;
  std::optional<std::size_t> style{};  // colour and dashes; default: the index of the curve
  std::vector<std::string> labels{};   // label i is beside point i, not over others; may be shorter than x
  bool thin = false;                   // a thin line in ink, over the curves before it
};

/// The area between two curves, lightly in the colour of a curve.
struct ChartBand {
  std::vector<double> x, low, high;
  std::size_t style = 0;
};

/// A value on the x axis with a name above it.
struct ChartAnnotation {
  double x = 0;
  std::string name;
};

struct ChartAxis {
  std::string label;         // includes the unit: "hoop frequency, Hz"
  bool logarithmic = false;  // all values above zero
  std::optional<std::pair<double, double>> range{};
  std::vector<double> ticks{};  // in place of round numbers
};

struct LineChart {
  std::string title;
  ChartAxis x, y;
  std::vector<ChartCurve> curves;
  std::vector<ChartBand> bands{};
  std::vector<ChartAnnotation> flags{};
};

/// The background of a chart: white paper, or a page whose style sheet defines the colours.
enum class ChartTheme : std::uint8_t { paper, page };

/// The chart as an SVG 1.1 document: ticks at round numbers, colours for the colour-blind, dashes that differ in print,
/// text of 12 px and more. A line of 1500 points or more is reduced to the extremes of neighbouring points. If a curve
/// consists of points alone, the names form a legend.
std::string line_chart_svg(const LineChart& chart, ChartTheme theme = ChartTheme::paper);

/// The same as a part of a larger drawing.
SvgFragment line_chart_fragment(const LineChart& chart, ChartTheme theme = ChartTheme::paper);

/// Several charts, stacked, as one document.
std::string line_charts_svg(const std::vector<LineChart>& charts);

}  // namespace percuss::report
