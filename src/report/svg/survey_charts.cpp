#include "report/svg/survey_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/svg/analysis_charts.hpp"
#include "report/svg/line_chart.hpp"
#include "report/svg/shape_svg.hpp"
#include "report/svg/wireframe.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

constexpr double kTurn_rad = 0.35 * std::numbers::pi,
                 kTilt_rad = 0.15 * std::numbers::pi;  // the initial view of the page
constexpr double kShapeAmplitude = 0.15;               // of the frame's radius
constexpr double kCross = 0.02;                        // half the width of a point's cross, of the frame's radius
constexpr double kLevelFloor = 1e-300;

// Projects a point onto the drawing.
std::array<double, 2> seen(const std::array<double, 3>& at) {
  const double across = at[0] * std::cos(kTurn_rad) - at[1] * std::sin(kTurn_rad);
  const double away = at[0] * std::sin(kTurn_rad) + at[1] * std::cos(kTurn_rad);
  return {across, at[2] * std::cos(kTilt_rad) + away * std::sin(kTilt_rad)};
}

double radius_of(const Wireframe& frame) {
  std::array<double, 3> middle{};
  for (const auto& at : frame.points) {
    for (std::size_t i = 0; i < 3; ++i) middle.at(i) += at.at(i) / static_cast<double>(frame.points.size());
  }
  double radius = 0;
  for (const auto& at : frame.points)
    radius = std::max(radius, std::hypot(at[0] - middle[0], at[1] - middle[1], at[2] - middle[2]));
  return radius;
}

std::vector<Polyline> lines_of(const Wireframe& frame, const WireframeMode& mode, double amount, double arm) {
  const auto place = [&](std::size_t i) {
    std::array<double, 3> at = frame.points[i];
    for (std::size_t k = 0; k < 3; ++k) at.at(k) += amount * mode.moves[i].at(k).real();
    return seen(at);
  };
  std::vector<Polyline> lines;
  for (const auto& [from, to] : frame.lines) lines.push_back({place(from), place(to)});
  if (!lines.empty()) return lines;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {  // points without lines are drawn as crosses
    const auto [x, y] = place(i);
    lines.push_back({{x - arm, y}, {x + arm, y}});
    lines.push_back({{x, y - arm}, {x, y + arm}});
  }
  return lines;
}

std::vector<DeformedShape> shape_drawings(const pipeline::Survey& survey) {
  const Wireframe frame = wireframe(survey);
  const double radius = radius_of(frame);
  std::vector<DeformedShape> drawings;
  for (const WireframeMode& mode : frame.modes) {
    double largest = 0;
    for (const auto& move : mode.moves) {
      for (const Complex& component : move) largest = std::max(largest, std::abs(component));
    }
    if (frame.points.size() < 2 || !(largest > 0)) continue;
    drawings.push_back({.name = fmt::format("{}, {} Hz", mode.name, hertz_text(mode.freq_Hz)),
                        .rest = lines_of(frame, mode, 0, kCross * radius),
                        .moved = lines_of(frame, mode, kShapeAmplitude * radius / largest, kCross * radius)});
  }
  return drawings;
}

LineChart indicator_chart(const pipeline::Survey& survey) {
  LineChart chart{.title = "Mode indicator: singular values of the FRFs",
                  .x = {.label = "frequency, Hz"},
                  .y = {.label = "dB re 1 (m/s²)/N"}};
  const acquire::LineRange band = survey.band();
  constexpr std::array<const char*, 3> kNames{"largest", "second", "third"};
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(kNames.size(), survey.indicator().cols()); ++i) {
    ChartCurve curve{.name = kNames.at(static_cast<std::size_t>(i))};
    for (std::size_t k = 0; k < band.count; ++k) {
      curve.x.push_back(band.freq_Hz(k));
      curve.y.push_back(20 * std::log10(std::max(survey.indicator()(static_cast<Eigen::Index>(k), i), kLevelFloor)));
    }
    chart.curves.push_back(std::move(curve));
  }
  for (std::size_t m = 0; m < survey.classifications().size(); ++m) {
    chart.flags.push_back(
        {.x = survey.analysis().modes()[m].pole.freq_Hz, .name = mode_name(survey.classifications()[m], m)});
  }
  return chart;
}

}  // namespace

const std::vector<std::string>& survey_chart_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"shapes", "indicator"};
    all.insert(all.end(), analysis_chart_names().begin(), analysis_chart_names().end());
    return all;
  }();
  return names;
}

std::vector<SvgFragment> survey_charts(const pipeline::Survey& survey, const std::vector<std::string>& names) {
  const auto wants = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  const bool possible = survey.analysis().possible();
  std::vector<SvgFragment> pieces;
  if (wants("shapes") && possible && !survey.shapes().empty()) {
    if (const auto drawings = shape_drawings(survey); !drawings.empty())
      pieces.push_back(shape_svg("Mode shapes", drawings));
  }
  if (wants("indicator") && possible) pieces.push_back(line_chart_fragment(indicator_chart(survey)));
  for (SvgFragment& piece : analysis_charts(
           survey.analysis(), possible ? survey.classifications() : std::vector<identify::ModeClassification>(), names))
    pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace percuss::report
