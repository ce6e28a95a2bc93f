#include "report/html/shapes_section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/html/mac_table.hpp"
#include "report/html/page_elements.hpp"
#include "report/json/json_document.hpp"
#include "report/svg/wireframe.hpp"
#include "report/text/number_format.hpp"

namespace percuss::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMoveSteps = 1e4;  // of the largest displacement: finer than a screen

// Six digits exceed the resolution of a plot.
double shown(double value) { return std::isfinite(value) ? std::stod(fmt::format("{:.6g}", value)) : 0; }

Json vectors_json(const std::vector<std::array<double, 3>>& vectors, double step) {
  Json out = Json::array();
  for (const auto& v : vectors) {
    Json at = Json::array();
    for (const double x : v) at.push_back(step > 0 ? std::round(x / step) * step : shown(x));
    out.push_back(std::move(at));
  }
  return out;
}

const char* name_of_layout(acquire::PointLayout layout) {
  switch (layout) {
    case acquire::PointLayout::line:
      return "line";
    case acquire::PointLayout::grid:
    case acquire::PointLayout::plane:
      return "plane";
    case acquire::PointLayout::surface:
      return "surface";
    default:
      return "scattered";
  }
}

Json mode_json(const WireframeMode& mode) {
  Json moves = Json::array();
  for (const auto& move : mode.moves) {
    for (const Complex& component : move) {
      moves.push_back(std::lround(component.real() * kMoveSteps));
      moves.push_back(std::lround(component.imag() * kMoveSteps));
    }
  }
  return {{"name", mode.name}, {"hz", mode.freq_Hz}, {"mpc", shown(mode.mpc)}, {"moves", std::move(moves)}};
}

MacMatrix auto_mac(const pipeline::Survey& survey) {
  MacMatrix out{.caption = "AutoMAC: 1 where two modes have the same shape on these points",
                .rows = {},
                .columns = {},
                .values = {}};
  const auto& macs = survey.macs();
  for (std::size_t m = 0; m < macs.size(); ++m) {
    const std::string freq = hertz_text(survey.modes()[m].pole.freq_Hz);
    out.rows.push_back(fmt::format("{}: {} Hz", m + 1, freq));
    out.columns.push_back(fmt::format("{}", m + 1));
    out.values.emplace_back();
    for (const identify::Mac& mac : macs[m]) out.values.back().emplace_back(mac.value);
  }
  return out;
}

// The points of the geometry that have no shape, because they were not measured.
std::string unmeasured_points(const pipeline::Survey& survey) {
  constexpr std::size_t kMaxListed = 12;
  if (!survey.geometry()) return "";
  const std::set<int> measured = survey.places();
  std::string list;
  std::size_t count = 0;
  for (const acquire::GeometryPoint& one : survey.geometry()->points) {
    if (measured.contains(one.point) || ++count > kMaxListed) continue;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", survey.stated_number(one.point));
  }
  if (count == 0) return "";
  const std::string more = count > kMaxListed ? fmt::format(" and {} more", count - kMaxListed) : "";
  return page_paragraph(fmt::format("Not measured, and therefore not drawn: {} {}{} of the geometry.",
                                    count == 1 ? "point" : "points", list, more));
}

}  // namespace

std::string shapes_section(const pipeline::Survey& survey, const std::string& warnings) {
  return page_section("shapes", "Mode shapes",
                      "<figure class=\"picture\" data-plot=\"shapes\" role=\"group\" aria-label=\"Animated mode shapes "
                      "of the structure.\"></figure>\n" +
                          unmeasured_points(survey) + mac_table_html(auto_mac(survey)) + warnings);
}

std::string shapes_plot_data(const pipeline::Survey& survey) {
  constexpr double kNormalStep = 1e-3;
  const Wireframe frame = wireframe(survey);
  Json sensors = Json::array(), modes = Json::array();
  for (const WireframeSensor& sensor : frame.sensors)
    sensors.push_back({{"at", sensor.at}, {"direction", vectors_json({sensor.direction}, kNormalStep)[0]}});
  for (const WireframeMode& mode : frame.modes) modes.push_back(mode_json(mode));
  return ascii_text(Json{{"shapes",
                          {{"layout", name_of_layout(frame.mesh.layout)},
                           {"points", vectors_json(frame.mesh.points, 0)},
                           {"lines", frame.mesh.lines},
                           {"faces", frame.mesh.faces},
                           {"normals", vectors_json(frame.mesh.normals, kNormalStep)},
                           {"sensors", std::move(sensors)},
                           {"modes", std::move(modes)}}}});
}

}  // namespace percuss::report
