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

/// One line of a chart: its name, written at its end, and its points in the order of x; NaN breaks the line.
struct ChartCurve {
  std::string name;
  std::vector<double> x, y;
  bool marks = false;  // the points themselves as well
  bool line = true;    // false: the points alone, in any order
  ChartMark mark = ChartMark::circle;
  std::optional<std::size_t> style{};  // colour and dashes: its place among the curves unless given
  std::vector<std::string> labels{};   // beside the points, as far as there are any
  bool thin = false;                   // in ink, over the others
};

/// The ground between two lines over x, lightly in the colour of a curve.
struct ChartBand {
  std::vector<double> x, low, high;
  std::size_t style = 0;
};

/// A place on the x axis with a name above it.
struct ChartAnnotation {
  double x = 0;
  std::string name;
};

struct ChartAxis {
  std::string label;         // with its unit: "hoop frequency, Hz"
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

/// What a chart is drawn on: white paper, or a page whose style sheet has the colours.
enum class ChartTheme : std::uint8_t { paper, page };

/// The chart as a document of its own (SVG 1.1): ticks at round numbers, colours that stay apart for the colour-blind
/// and dashes that stay apart in print, text of 12 px and more. At most a thousand points of a line are drawn: the
/// extremes of its neighbours stand for the others. Where a curve is points alone, the names stand in a legend.
std::string line_chart_svg(const LineChart& chart, ChartTheme ground = ChartTheme::paper);

/// The same as a part of a larger one.
SvgFragment line_chart_fragment(const LineChart& chart, ChartTheme ground = ChartTheme::paper);

/// Several charts, one under the other, as one document.
std::string line_charts_svg(const std::vector<LineChart>& charts);

}  // namespace percuss::report
