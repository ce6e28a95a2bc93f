#include "charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/svg/line_chart.hpp"

namespace percuss::accuracy {
namespace {

constexpr std::array kMarks{report::ChartMark::circle, report::ChartMark::square, report::ChartMark::triangle,
                            report::ChartMark::diamond};
constexpr std::size_t kBlack = 4;  // among the styles of a chart
constexpr double kMega = 1e6;
constexpr double kNearlyEqual = 2.5;  // factor

bool is_plottable(const Figure& figure) {
  return std::isfinite(figure.error) && figure.error > 0 && figure.time_ratio > 0;
}

// The methods of a sweep, in order of appearance. The chart has one symbol per method.
std::vector<std::string> methods_of(const Sweep& sweep) {
  std::vector<std::string> names;
  for (const Case& one : sweep.cases) {
    for (const Figure& figure : one.figures) {
      if (std::find(names.begin(), names.end(), figure.method) == names.end()) names.push_back(figure.method);
    }
  }
  return names;
}

// The points of one method in one case. The symbol shows the method, the colour the case. Labels are kept only where
// there are two or more points.
report::ChartCurve points_of(const Case& one, std::size_t style, const std::string& method, report::ChartMark mark) {
  report::ChartCurve curve{.name = {}, .x = {}, .y = {}, .line = false, .mark = mark, .style = style};
  for (const Figure& figure : one.figures) {
    if (figure.method != method || !is_plottable(figure)) continue;
    curve.x.push_back(figure.time_ratio);
    curve.y.push_back(figure.error);
    curve.labels.push_back(figure.label);
  }
  if (curve.x.size() < 2) curve.labels.clear();
  return curve;
}

// The Pareto-optimal figures, fastest first.
report::ChartCurve front_of(const Case& one, std::size_t style) {
  std::vector<const Figure*> front;
  for (const Figure& figure : one.figures) {
    if (figure.on_pareto_front && is_plottable(figure)) front.push_back(&figure);
  }
  std::sort(front.begin(), front.end(), [](const Figure* a, const Figure* b) { return a->time_ratio < b->time_ratio; });
  report::ChartCurve curve{.name = one.value, .x = {}, .y = {}, .style = style};
  for (const Figure* figure : front) {
    curve.x.push_back(figure->time_ratio);
    curve.y.push_back(figure->error);
  }
  return curve;
}

// Sets a range of at least one decade, so small differences look small, and enough round numbers as ticks.
void set_range(report::ChartAxis& axis, const std::vector<report::ChartCurve>& curves,
               std::vector<double> report::ChartCurve::*values) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const report::ChartCurve& curve : curves) {
    for (const double value : curve.*values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (!(high > 0)) return;
  const double margin = std::max({1.15, std::pow(high / low, 0.05), std::sqrt(10 * low / high)});
  low /= margin;
  high *= margin;
  axis.range = {low, high};
  if (high / low > 1000) return;
  for (double decade = std::pow(10, std::floor(std::log10(low))); decade < high; decade *= 10) {
    for (const double digit : {1, 2, 5}) {
      if (digit * decade >= low && digit * decade <= high) axis.ticks.push_back(digit * decade);
    }
  }
}

report::LineChart sweep_chart(const TaskFigures& task, const Sweep& sweep) {
  report::LineChart chart{
      .title = fmt::format("{}: error against time, by {}; line: Pareto-optimal", task.title, sweep.over),
      .x = {.label = fmt::format("time, multiples of {}", task.time), .logarithmic = true},
      .y = {.label = task.error, .logarithmic = true},
      .curves = {}};
  const std::vector<std::string> methods = methods_of(sweep);
  for (std::size_t m = 0; m < methods.size(); ++m) {  // for the legend
    chart.curves.push_back(
        {.name = methods[m], .x = {}, .y = {}, .line = false, .mark = kMarks.at(m), .style = kBlack});
  }
  for (std::size_t c = 0; c < sweep.cases.size(); ++c) {
    const std::size_t style = c < kBlack ? c : c + 1;
    chart.curves.push_back(front_of(sweep.cases[c], style));
    for (std::size_t m = 0; m < methods.size(); ++m)
      chart.curves.push_back(points_of(sweep.cases[c], style, methods[m], kMarks.at(m)));
  }
  set_range(chart.x, chart.curves, &report::ChartCurve::x);
  set_range(chart.y, chart.curves, &report::ChartCurve::y);
  return chart;
}

// Nearly equal figures need no chart.
bool worth_a_chart(const Sweep& sweep) {
  std::vector<double> errors, times;
  for (const Case& one : sweep.cases) {
    for (const Figure& figure : one.figures) {
      if (!is_plottable(figure)) continue;
      errors.push_back(figure.error);
      times.push_back(figure.time_ratio);
    }
  }
  const auto differ = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high > kNearlyEqual * *low;
  };
  return !errors.empty() && (differ(errors) || differ(times));
}

report::LineChart growth_chart(const std::vector<Scaling>& scalings, std::string title, std::string label,
                               double (*value)(const ScalePoint&)) {
  report::LineChart chart{.title = std::move(title),
                          .x = {.label = "number of samples, channels, hits, modes or files", .logarithmic = true},
                          .y = {.label = std::move(label), .logarithmic = true},
                          .curves = {}};
  for (const Scaling& scaling : scalings) {
    report::ChartCurve curve{.name = scaling.of, .x = {}, .y = {}, .marks = true};
    curve.mark = kMarks.at(chart.curves.size() % kMarks.size());
    for (const ScalePoint& point : scaling.points) {
      if (!(value(point) > 0)) continue;
      curve.x.push_back(point.n);
      curve.y.push_back(value(point));
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

}  // namespace

std::string task_svg(const TaskFigures& task) {
  std::vector<report::LineChart> charts;
  for (const Sweep& sweep : task.sweeps) {
    if (worth_a_chart(sweep)) charts.push_back(sweep_chart(task, sweep));
  }
  return report::line_charts_svg(charts);
}

std::string scaling_svg(const std::vector<Scaling>& scalings) {
  return report::line_charts_svg({growth_chart(scalings, "Time of an analysis over its size", "time, s",
                                               [](const ScalePoint& point) { return point.seconds; }),
                                  growth_chart(scalings, "Memory of an analysis over its size", "peak memory, MB",
                                               [](const ScalePoint& point) { return point.peak_bytes / kMega; })});
}

}  // namespace percuss::accuracy
