#include "report/svg/tube_mesh.hpp"

#include <cmath>
#include <iterator>
#include <optional>

#include "core/units.hpp"

namespace percuss::report {
namespace {

constexpr double kMaxOpening_rad = 126 * kDegree_rad;  // a ring of three points has openings of 120°
constexpr double kFullTurn_rad = 360 * kDegree_rad;

struct RingPoint {
  double angle_rad = 0;  // 0 … 2π
  std::size_t at = 0;    // index of the point in the mesh
};
using Ring = std::map<long, RingPoint>;  // by angle in 0.001°

// The pairs of neighbours on a ring, by angle.
std::vector<std::pair<long, long>> neighbours_on(const Ring& ring) {
  std::vector<std::pair<long, long>> out;
  for (auto p = ring.begin(); std::next(p) != ring.end(); ++p) {
    const auto next = std::next(p);
    if (ring.size() == 2 || next->second.angle_rad - p->second.angle_rad <= kMaxOpening_rad)
      out.emplace_back(p->first, next->first);
  }
  const double opening = ring.begin()->second.angle_rad + kFullTurn_rad - ring.rbegin()->second.angle_rad;
  if (ring.size() > 2 && opening <= kMaxOpening_rad) out.emplace_back(ring.rbegin()->first, ring.begin()->first);
  return out;
}

std::optional<std::size_t> at_angle(const Ring& ring, long angle) {
  const auto found = ring.find(angle);
  return found == ring.end() ? std::nullopt : std::optional(found->second.at);
}

}  // namespace

acquire::StructureMesh tube_mesh(const acquire::Geometry& geometry, const std::map<int, std::size_t>& index) {
  std::map<long, Ring> rings;  // by position in µm
  acquire::StructureMesh mesh{.layout = acquire::PointLayout::surface, .lines = {}, .faces = {}, .normals = {}};
  mesh.normals.assign(index.size(), {0, 0, 1});
  for (const acquire::GeometryPoint& p : geometry.points) {
    const auto found = index.find(p.point);
    if (found == index.end()) continue;
    const double turned = std::remainder(p.angle_rad, kFullTurn_rad),
                 angle = turned < 0 ? turned + kFullTurn_rad : turned;
    rings[std::lround(p.position_m * 1e6)][std::lround(angle * kRadian_deg * 1e3)] = {angle, found->second};
    auto& normal = mesh.normals[found->second];
    normal = {0, 0, 0};
    normal.at((geometry.axis + 1) % 3) = std::cos(p.angle_rad);
    normal.at((geometry.axis + 2) % 3) = std::sin(p.angle_rad);
  }
  std::map<long, std::size_t> last;  // the last point along the tube at each angle
  for (auto ring = rings.begin(); ring != rings.end(); ++ring) {
    const auto next = std::next(ring);
    for (const auto& [from, to] : neighbours_on(ring->second)) {
      const std::size_t a = ring->second.at(from).at, b = ring->second.at(to).at;
      mesh.lines.push_back({a, b});
      if (next == rings.end()) continue;
      const auto c = at_angle(next->second, to), d = at_angle(next->second, from);
      if (c && d) mesh.faces.push_back({a, b, *c, *d});
    }
    for (const auto& [angle, point] : ring->second) {
      const auto [before, first] = last.emplace(angle, point.at);
      if (first) continue;
      mesh.lines.push_back({before->second, point.at});
      before->second = point.at;
    }
  }
  return mesh;
}

}  // namespace percuss::report
