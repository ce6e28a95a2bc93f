#include "report/svg/plot_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "core/units.hpp"

namespace percuss::report {
const acquire::GeometryPoint* geometry_point_of(const pipeline::Survey& survey, std::size_t point) {
  if (!survey.geometry()) return nullptr;
  const auto& points = survey.geometry()->points;
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const acquire::GeometryPoint& p) { return p.point == static_cast<int>(point); });
  return found == points.end() ? nullptr : &*found;
}

std::optional<std::array<double, 3>> plot_position(const pipeline::Survey& survey, std::size_t point) {
  const acquire::GeometryPoint* place = geometry_point_of(survey, point);
  if (place == nullptr) return std::nullopt;
  if (place->xyz_m) return place->xyz_m;
  return std::array{place->position_m, place->radius_m * std::cos(place->angle_rad),
                    place->radius_m * std::sin(place->angle_rad)};
}

std::array<double, 3> outward_normal(const pipeline::Survey* survey, const pipeline::Analysis& analysis,
                                     std::size_t point, std::size_t channel, bool sensors) {
  const auto outwards = [](double angle_rad) { return std::array{0.0, std::cos(angle_rad), std::sin(angle_rad)}; };
  if (survey != nullptr && survey->geometry() && survey->geometry()->tube) {
    for (const acquire::GeometryPoint& p : survey->geometry()->points) {
      if (p.point == static_cast<int>(point)) return outwards(p.angle_rad);
    }
  }
  const auto& accel = analysis.record().accel;
  if (sensors && channel < accel.size() && accel[channel].angle_rad) return outwards(*accel[channel].angle_rad);
  return {0, 0, 1};
}

std::vector<acquire::TraceLine> plot_lines(const pipeline::Survey& survey, const std::set<int>& points) {
  std::vector<acquire::TraceLine> out;
  for (const acquire::TraceLine& line : survey.analysis().record().trace_lines) {
    if (points.contains(line[0]) && points.contains(line[1])) out.push_back(line);
  }
  if (!out.empty() || !survey.geometry() || !survey.geometry()->tube) return out;
  std::map<long, std::map<long, int>> rings, lines;  // by position in µm and angle in 0.001°
  for (const acquire::GeometryPoint& p : survey.geometry()->points) {
    if (!points.contains(p.point)) continue;
    const long along = std::lround(p.position_m * 1e6), around = std::lround(p.angle_rad * kRadian_deg * 1e3);
    rings[along][around] = p.point;
    lines[around][along] = p.point;
  }
  const auto connect = [&](const std::map<long, int>& members, bool ring) {
    for (auto at = members.begin(); std::next(at) != members.end(); ++at)
      out.push_back({at->second, std::next(at)->second});
    if (ring && members.size() > 2) out.push_back({members.rbegin()->second, members.begin()->second});
  };
  for (const auto& [place, members] : rings) connect(members, true);
  for (const auto& [place, members] : lines) connect(members, false);
  return out;
}

}  // namespace percuss::report
