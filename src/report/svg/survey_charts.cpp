#include "report/svg/survey_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "report/svg/analysis_charts.hpp"
#include "report/svg/line_chart.hpp"
#include "report/svg/shape_svg.hpp"
#include "report/svg/wireframe.hpp"
#include "report/text/analysis_tables.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

// The direction from which the page first shows every layout except a line.
constexpr double kTurn_rad = std::numbers::pi / 6, kTilt_rad = std::numbers::pi / 6;
constexpr double kShapeAmplitude = 0.15;  // of the frame's radius
constexpr double kCross = 0.02;           // half the width of a point's cross, of the frame's radius
constexpr double kLevelFloor = 1e-300;

// Projects a point onto the drawing.
std::array<double, 2> seen(const std::array<double, 3>& at) {
  const double across = at[0] * std::cos(kTurn_rad) - at[1] * std::sin(kTurn_rad);
  const double away = at[0] * std::sin(kTurn_rad) + at[1] * std::cos(kTurn_rad);
  return {across, at[2] * std::cos(kTilt_rad) + away * std::sin(kTilt_rad)};
}

double radius_of(const PlotMesh& mesh) {
  std::array<double, 3> middle{};
  for (const auto& at : mesh.points) {
    for (std::size_t i = 0; i < 3; ++i) middle.at(i) += at.at(i) / static_cast<double>(mesh.points.size());
  }
  double radius = 0;
  for (const auto& at : mesh.points)
    radius = std::max(radius, std::hypot(at[0] - middle[0], at[1] - middle[1], at[2] - middle[2]));
  return radius;
}

// The mesh on the drawing; lines in halves, so that each half has the colour of its end.
class DrawnMesh {
 public:
  DrawnMesh(const PlotMesh& mesh, const WireframeMode& mode, double amount)
      : mesh_(mesh), mode_(mode), amount_(amount), arm_(kCross * radius_of(mesh)) {}

  std::array<double, 2> place(std::size_t i) const {
    std::array<double, 3> at = mesh_.points[i];
    for (std::size_t k = 0; k < 3; ++k) at.at(k) += amount_ * mode_.moves[i].at(k).real();
    return seen(at);
  }
  double value(std::size_t i) const {
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) along += mode_.moves[i].at(k).real() * mesh_.normals[i].at(k);
    return std::clamp(along, -1.0, 1.0);
  }
  void add_lines(std::vector<Polyline>& lines, std::vector<double>* values) const {
    const auto add = [&](const Polyline& line, std::size_t point) {
      lines.push_back(line);
      if (values != nullptr) values->push_back(value(point));
    };
    for (const auto& ends : mesh_.lines) {
      const auto a = place(ends[0]), b = place(ends[1]);
      const std::array<double, 2> middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
      add({a, middle}, ends[0]);
      add({middle, b}, ends[1]);
    }
    if (!mesh_.lines.empty()) return;
    for (std::size_t i = 0; i < mesh_.points.size(); ++i) {  // points without lines are drawn as crosses
      const auto [x, y] = place(i);
      add({{x - arm_, y}, {x + arm_, y}}, i);
      add({{x, y - arm_}, {x, y + arm_}}, i);
    }
  }
  // Points that deflect more than their neighbours, and at least half as far as the point that deflects most.
  std::vector<DeformedShape::Sign> signs() const {
    std::vector<bool> extreme(mesh_.points.size());
    double largest = 0;
    for (std::size_t i = 0; i < extreme.size(); ++i) largest = std::max(largest, std::abs(value(i)));
    for (std::size_t i = 0; i < extreme.size(); ++i) extreme[i] = largest > 0 && std::abs(value(i)) >= 0.5 * largest;
    for (const auto& [a, b] : mesh_.lines) extreme[std::abs(value(a)) < std::abs(value(b)) ? a : b] = false;
    std::vector<DeformedShape::Sign> out;
    for (std::size_t i = 0; i < extreme.size(); ++i) {
      if (extreme[i]) out.push_back({.at = place(i), .positive = value(i) > 0});
    }
    return out;
  }

 private:
  const PlotMesh& mesh_;
  const WireframeMode& mode_;
  double amount_, arm_;
};

std::vector<DeformedShape> shape_drawings(const pipeline::Survey& survey) {
  const Wireframe frame = wireframe(survey);
  if (frame.mesh.points.size() < 2) return {};
  const double amplitude = kShapeAmplitude * radius_of(frame.mesh);
  std::vector<DeformedShape> drawings;
  for (const WireframeMode& mode : frame.modes) {
    DeformedShape drawing{
        .name = fmt::format("{}, {} Hz", mode.name, hertz_text(mode.freq_Hz)), .rest = {}, .moved = {}, .values = {}};
    DrawnMesh(frame.mesh, mode, 0).add_lines(drawing.rest, nullptr);
    const DrawnMesh moved(frame.mesh, mode, amplitude);
    moved.add_lines(drawing.moved, &drawing.values);
    drawing.signs = moved.signs();
    drawings.push_back(std::move(drawing));
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
    chart.flags.push_back({.x = survey.modes()[m].pole.freq_Hz, .name = mode_name(survey.classifications()[m], m)});
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
           survey.analysis(), possible ? survey.classifications() : std::vector<identify::ModeClassification>(), names,
           possible ? &survey.modes() : nullptr))
    pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace percuss::report
