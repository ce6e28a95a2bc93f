#include "report/svg/line_chart.hpp"
#include "report/svg/chart_scale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace percuss::report::line_chart_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(RoundTicks, AreRoundAndInside) {
  EXPECT_THAT(round_ticks(0.03, 5.2, 5), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(round_ticks(-100, 100, 4), ElementsAre(-100, -50, 0, 50, 100));
  EXPECT_THAT(round_ticks(1, 1, 4), IsEmpty());
}

LineChart chart() {
  return {.title = "COR < 1 & falling",
          .x = {.label = "hoop frequency, Hz"},
          .y = {.label = "COR"},
          .curves = {{.name = "a", .x = {0, 1, 2, 3}, .y = {1, 2, std::numeric_limits<double>::quiet_NaN(), 4}},
                     {.name = "b", .x = {0, 3}, .y = {4, 4}, .marks = true}}};
}

TEST(LineChart, DrawsCurvesInsideThePlotAndBreaksThemAtNan) {
  const std::string svg = line_chart_svg(chart());
  EXPECT_THAT(svg, HasSubstr("M72.0 371.4L254.7 266.5M620.0 56.6\""));  // margins of 4 % of the values' range
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"620.0\""));
}

// A gap of either edge divides the band into areas, each closed by its own edges.
TEST(LineChart, DividesABandAtGaps) {
  const double gap = std::numeric_limits<double>::quiet_NaN();
  const auto band_of = [&](const std::vector<double>& low, const std::vector<double>& high) {
    LineChart chart{.x = {.range = std::pair(0.0, 4.0)},
                    .y = {.range = std::pair(0.0, 4.0)},
                    .curves = {{.x = {0, 4}, .y = {0, 4}}},
                    .bands = {{.x = {0, 1, 2, 3, 4}, .low = low, .high = high}}};
    const std::string svg = line_chart_svg(chart);
    const std::size_t end = svg.find("\" fill=\"#0072B2\" fill-opacity"), begin = svg.rfind("<path d=\"", end) + 9;
    return svg.substr(begin, end - begin);
  };
  EXPECT_EQ(band_of({1, 1, 1, 1, 1}, {3, 3, 3, 3, 3}),
            "M72.0 129.0L209.0 129.0L346.0 129.0L483.0 129.0L620.0 129.0"
            "L620.0 299.0L483.0 299.0L346.0 299.0L209.0 299.0L72.0 299.0Z");
  const char* const two =
      "M72.0 129.0L209.0 129.0L209.0 299.0L72.0 299.0ZM483.0 129.0L620.0 129.0L620.0 299.0L483.0 299.0Z";
  EXPECT_EQ(band_of({1, 1, gap, 1, 1}, {3, 3, gap, 3, 3}), two);
  EXPECT_EQ(band_of({1, 1, gap, 1, 1}, {3, 3, 3, 3, 3}), two);
  EXPECT_EQ(band_of({1, 1, 1, 1, 1}, {3, 3, gap, 3, 3}), two);
  EXPECT_EQ(band_of({gap, 1, 1, gap, gap}, {gap, 3, 3, gap, 3}), "M209.0 129.0L346.0 129.0L346.0 299.0L209.0 299.0Z");
}

TEST(LineChart, DrawsPointsAloneWithALegend) {
  const std::string svg = line_chart_svg(
      {.curves = {{.name = "wood", .x = {3, 1, 2}, .y = {1, 2, 3}, .line = false, .labels = {"A", "", "<B"}},
                  {.name = "composite", .x = {1}, .y = {1}, .line = false, .mark = ChartMark::diamond},
                  {.name = "trend", .x = {1, 3}, .y = {1, 3}, .style = 0}}});
  EXPECT_THAT(svg, HasSubstr(">wood</text>"));
  EXPECT_THAT(svg, HasSubstr(">A</text>"));
  EXPECT_THAT(svg, HasSubstr(">&lt;B</text>"));
  EXPECT_THAT(svg,
              HasSubstr("<circle cx=\"599.7\" cy=\"371.4\" r=\"3\" fill=\"#0072B2\"/>"));  // 4 % of the range inwards
  EXPECT_THAT(svg, HasSubstr("stroke=\"#0072B2\" stroke-width=\"1.8\""));                  // the given style
}

// Labels of neighbouring points move apart; those for which there is no room are left out.
TEST(LineChart, KeepsLabelsApart) {
  const auto chart_of = [](std::size_t count) {
    ChartCurve curve{.line = false};
    for (std::size_t i = 0; i < count; ++i) {
      curve.x.push_back(1 + 0.001 * static_cast<double>(i));
      curve.y.push_back(0);
      curve.labels.push_back("node " + std::to_string(i));
    }
    return LineChart{.x = {.range = std::pair(0.0, 4.0)}, .y = {.range = std::pair(-1.0, 1.0)}, .curves = {curve}};
  };
  const auto heights = [](const std::string& svg) {
    std::multiset<std::string> out;
    for (std::size_t at = svg.find(">node "); at != std::string::npos; at = svg.find(">node ", at + 1)) {
      const std::size_t y = svg.rfind("y=\"", at) + 3;
      out.insert(svg.substr(y, svg.find('"', y) - y));
    }
    return out;
  };
  const auto three = heights(line_chart_svg(chart_of(3)));
  EXPECT_EQ(three.size(), 3U);
  EXPECT_EQ(std::set<std::string>(three.begin(), three.end()).size(), 3U);
  EXPECT_EQ(heights(line_chart_svg(chart_of(30))).size(), 7U) << "three lines above and below the first label";
}

TEST(LineChart, MarksDifferWithoutColour) {
  std::set<std::string> shapes;
  for (const ChartMark mark : {ChartMark::circle, ChartMark::plus, ChartMark::open_diamond, ChartMark::diamond,
                               ChartMark::triangle, ChartMark::square, ChartMark::cross})
    shapes.insert(line_chart_svg({.curves = {{.name = "a", .x = {1}, .y = {1}, .line = false, .mark = mark}}}));
  EXPECT_EQ(shapes.size(), 7U);
}

TEST(LineChart, EscapesMarkup) { EXPECT_THAT(line_chart_svg(chart()), HasSubstr("COR &lt; 1 &amp; falling")); }

TEST(LineChart, KeepsNamesApart) {
  const std::string svg = line_chart_svg(chart());
  EXPECT_THAT(svg, HasSubstr("y=\"60.6\" fill=\"#0072B2\">a<"));
  EXPECT_THAT(svg, HasSubstr("y=\"75.6\" fill=\"#B34700\">b<"));  // darker than its curve, for legibility
}

TEST(LineChart, WorksWithoutValues) {
  EXPECT_THAT(line_chart_svg({.title = "nothing"}), Not(HasSubstr("nan")));
  EXPECT_THAT(line_chart_svg({.curves = {{.name = "one", .x = {5}, .y = {7}}}}), Not(HasSubstr("nan")));
}

TEST(LineChart, ReducesLongCurves) {
  ChartCurve curve{.name = "noise"};
  for (int i = 0; i < 100000; ++i) {
    curve.x.push_back(i);
    curve.y.push_back(i == 77777 ? 9 : i % 2);
  }
  const std::string svg = line_chart_svg({.curves = {curve}});
  EXPECT_LT(svg.size(), 30000U);
  EXPECT_THAT(svg, HasSubstr(" 56.6L"));  // the extreme sample is kept
}

TEST(LineChart, HasTicksAtDecadesOnALogarithmicAxis) {
  const std::string svg =
      line_chart_svg({.x = {.logarithmic = true}, .y = {.logarithmic = true}, .curves = {{"", {1, 1000}, {1, 1e-6}}}});
  EXPECT_THAT(svg, HasSubstr("<text x=\"254.7\" y=\"402\" text-anchor=\"middle\">10</text>"));
  EXPECT_THAT(svg, HasSubstr(">1e-06<"));
}

}  // namespace percuss::report::line_chart_test
