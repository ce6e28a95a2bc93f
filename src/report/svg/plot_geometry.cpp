#include "report/svg/plot_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "report/svg/tube_mesh.hpp"

namespace percuss::report {
namespace {

constexpr double kBarrelRadius_m = 0.0333;
constexpr double kMinRadius = 0.05, kMaxRadius = 0.5;  // of a tube's length

double drawn_radius_m(const acquire::Geometry& geometry, const acquire::GeometryPoint& point) {
  if (point.radius_m > 0) return point.radius_m;
  const auto [low, high] =
      std::minmax_element(geometry.points.begin(), geometry.points.end(),
                          [](const auto& a, const auto& b) { return a.position_m < b.position_m; });
  const double length_m = high->position_m - low->position_m;
  return length_m > 0 ? std::clamp(kBarrelRadius_m, kMinRadius * length_m, kMaxRadius * length_m) : kBarrelRadius_m;
}

// The given lines between drawn points, by index.
std::vector<std::array<std::size_t, 2>> drawn_lines(std::span<const std::array<int, 2>> lines,
                                                    const std::map<int, std::size_t>& index) {
  std::vector<std::array<std::size_t, 2>> out;
  for (const auto& [from, to] : lines) {
    const auto a = index.find(from), b = index.find(to);
    if (a != index.end() && b != index.end()) out.push_back({a->second, b->second});
  }
  return out;
}

// The given faces whose corners are all drawn, by index.
std::vector<std::vector<std::size_t>> drawn_faces(const std::vector<std::vector<int>>& faces,
                                                  const std::map<int, std::size_t>& index) {
  std::vector<std::vector<std::size_t>> out;
  for (const auto& face : faces) {
    std::vector<std::size_t> corners;
    for (const int point : face) {
      const auto at = index.find(point);
      if (at != index.end()) corners.push_back(at->second);
    }
    if (corners.size() == face.size()) out.push_back(std::move(corners));
  }
  return out;
}

bool on_tube(const pipeline::Survey* survey) {
  return survey != nullptr && survey->geometry() && survey->geometry()->tube;
}

// The direction of a positive response that the geometry or the record states for the point, else for the sensor or the
// hammer. If the point has none: nothing on a tube, where the motion is radial; and nothing for a sensor whose angle is
// stated, because the angle takes precedence.
std::optional<acquire::Direction> stated_direction(const pipeline::Survey* survey, const pipeline::Analysis& analysis,
                                                   std::size_t point, std::size_t channel, bool sensors, bool tube) {
  const acquire::Record& record = analysis.record();
  if (survey != nullptr || record.sensor_roves == sensors) {
    const auto* const motion = acquire::find_motion(survey != nullptr ? survey->motions() : record.motions,
                                                    static_cast<int>(point), sensors ? channel : std::size_t{0});
    if (motion != nullptr && motion->along) return motion->along;
  }
  if (tube) return std::nullopt;
  if (!sensors) return record.force.axis;
  if (channel >= record.accel.size()) return std::nullopt;
  const bool angle_stated = record.accel[channel].angle_rad && !analysis.options().classes.angles_assumed;
  return angle_stated ? std::nullopt : record.accel[channel].axis;
}

// Adds the points that are at the place of another one. A place with one component moves along its stated direction.
void add_stated_directions(const pipeline::Survey& survey, PlotMesh& mesh) {
  const bool sensors = survey.roving() == identify::Roving::sensor, tube = on_tube(&survey);
  std::vector<std::size_t> components(mesh.points.size(), 0);
  std::vector<std::optional<acquire::Direction>> stated(mesh.points.size());
  for (const identify::ShapePlace& place : survey.shapes().front().places) {
    const auto at = mesh.index.find(survey.place_of(place.point));
    if (at == mesh.index.end()) continue;
    const std::size_t index = at->second;
    mesh.index.emplace(static_cast<int>(place.point), index);
    ++components[index];
    stated[index] = stated_direction(&survey, survey.analysis(), place.point, place.channel, sensors, tube);
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (components[i] == 1 && stated[i]) mesh.normals[i] = *stated[i];
  }
}

}  // namespace

std::optional<std::array<double, 3>> plot_position(const pipeline::Survey& survey, std::size_t point) {
  const acquire::GeometryPoint* place = survey.geometry_point(point);
  if (place == nullptr) return std::nullopt;
  if (place->xyz_m) return place->xyz_m;
  const double radius_m = drawn_radius_m(*survey.geometry(), *place);
  return std::array{place->position_m, radius_m * std::cos(place->angle_rad), radius_m * std::sin(place->angle_rad)};
}

PlotMesh plot_mesh(const pipeline::Survey& survey) {
  PlotMesh mesh;
  for (const identify::ShapePlace& place : survey.shapes().front().places) {
    if (survey.geometry_point(place.point) != nullptr) mesh.index.emplace(survey.place_of(place.point), 0);
  }
  for (auto& [number, index] : mesh.index) {
    index = mesh.points.size();
    mesh.number.push_back(number);
    mesh.points.push_back(*plot_position(survey, static_cast<std::size_t>(number)));
  }
  if (mesh.points.empty()) return mesh;
  const bool tube = survey.geometry()->tube;
  acquire::StructureMesh made = tube ? tube_mesh(*survey.geometry(), mesh.index) : acquire::structure_mesh(mesh.points);
  if (tube && 2 * made.lines.size() < mesh.points.size()) {  // no rings: points all over the tube
    acquire::StructureMesh surface = acquire::structure_mesh(mesh.points);
    surface.normals = std::move(made.normals);
    made = std::move(surface);
  }
  mesh.layout = made.layout;
  mesh.normals = std::move(made.normals);
  const acquire::Geometry& geometry = *survey.geometry();
  mesh.lines = drawn_lines(geometry.lines, mesh.index);
  mesh.faces = drawn_faces(geometry.faces, mesh.index);
  if (mesh.lines.empty() && mesh.faces.empty()) {
    mesh.lines = drawn_lines(survey.analysis().record().trace_lines, mesh.index);
    mesh.faces = drawn_faces(survey.analysis().record().trace_faces, mesh.index);
  }
  if (mesh.lines.empty() && mesh.faces.empty()) {
    mesh.lines = std::move(made.lines);
    mesh.faces = std::move(made.faces);
  }
  if (mesh.lines.empty()) mesh.lines = acquire::edges_of(mesh.faces);
  add_stated_directions(survey, mesh);
  return mesh;
}

std::array<double, 3> response_direction(const PlotMesh* mesh, const pipeline::Survey* survey,
                                         const pipeline::Analysis& analysis, std::size_t point, std::size_t channel,
                                         bool sensors) {
  const bool tube = on_tube(survey);
  if (const auto stated = stated_direction(survey, analysis, point, channel, sensors, tube)) return *stated;
  const auto& accel = analysis.record().accel;
  if (!tube && sensors && channel < accel.size() && accel[channel].angle_rad)
    return {0.0, std::cos(*accel[channel].angle_rad), std::sin(*accel[channel].angle_rad)};
  if (mesh == nullptr) return {0, 0, 1};
  const auto found = mesh->index.find(static_cast<int>(point));
  return found == mesh->index.end() ? std::array{0.0, 0.0, 1.0} : mesh->normals[found->second];
}

}  // namespace percuss::report
