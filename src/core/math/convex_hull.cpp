#include "core/math/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

namespace percuss {
inline namespace core {
namespace {

// Coordinates are whole numbers so small that their determinants fit 128 bits: in a plane x and y are at most 2²⁰ and
// heights at most 2⁴⁵, on a sphere all are at most 2³⁰. No sign is ever wrong, and the hull of any input is a closed
// surface.
__extension__ using Wide = __int128;
using Vertex = std::array<std::int64_t, 3>;

constexpr double kPlaneSteps = 1 << 20, kSphereSteps = 1 << 30;
constexpr std::int64_t kApex = std::int64_t{1} << 45U;  // above all lifted points, whose heights are at most 2⁴¹

std::array<Wide, 3> cross(const Vertex& a, const Vertex& b, const Vertex& c) {
  const auto difference = [&](const Vertex& to, std::size_t i) { return static_cast<Wide>(to.at(i) - a.at(i)); };
  const auto component = [&](std::size_t u, std::size_t v) {
    return difference(b, u) * difference(c, v) - difference(b, v) * difference(c, u);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

// Positive when p lies on the side from which a, b, c run counter-clockwise.
Wide volume(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) {
  const auto normal = cross(a, b, c);
  return normal[0] * (p[0] - a[0]) + normal[1] * (p[1] - a[1]) + normal[2] * (p[2] - a[2]);
}

// The first four points that span a volume.
std::optional<std::array<std::size_t, 4>> first_tetrahedron(const std::vector<Vertex>& points) {
  std::array<std::size_t, 4> at{};
  const auto find = [&](std::size_t corner, auto holds) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (!holds(points[i])) continue;
      at.at(corner) = i;
      return true;
    }
    return false;
  };
  const auto point = [&](std::size_t corner) -> const Vertex& { return points[at.at(corner)]; };
  const bool found = !points.empty() && find(1, [&](const Vertex& p) { return p != point(0); }) &&
                     find(2, [&](const Vertex& p) { return cross(point(0), point(1), p) != std::array<Wide, 3>{}; }) &&
                     find(3, [&](const Vertex& p) { return volume(point(0), point(1), point(2), p) != 0; });
  if (!found) return std::nullopt;
  if (volume(point(0), point(1), point(2), point(3)) > 0) std::swap(at[1], at[2]);
  return at;
}

// Adds one point after the other. The faces that a point sees from outside are replaced by triangles from their outline
// to the point. A face in the plane of the point is not seen: the facet grows.
std::vector<Triangle> convex_hull(const std::vector<Vertex>& points) {
  const auto start = first_tetrahedron(points);
  if (!start) return {};
  const auto [a, b, c, d] = *start;
  std::vector<Triangle> faces{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::erase_if(faces, [&](const Triangle& face) {
      if (volume(points[face[0]], points[face[1]], points[face[2]], points[p]) <= 0) return false;
      for (std::size_t i = 0; i < 3; ++i) edges.emplace(face.at(i), face.at((i + 1) % 3));
      return true;
    });
    for (const auto& [from, to] : edges) {
      if (!edges.contains({to, from})) faces.push_back({from, to, p});
    }
  }
  return faces;
}

}  // namespace

std::vector<Triangle> delaunay_triangles(std::span<const std::array<double, 2>> points) {
  if (points.size() < 3) return {};
  std::array<double, 2> low = points.front(), high = low, mean{};
  for (const auto& point : points) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!std::isfinite(point.at(i))) return {};
      low.at(i) = std::min(low.at(i), point.at(i));
      high.at(i) = std::max(high.at(i), point.at(i));
      mean.at(i) += point.at(i) / static_cast<double>(points.size());
    }
  }
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  if (!(size > 0) || !std::isfinite(size)) return {};
  // The apex closes the hull above. It stands over the mean, thus over the hull of the points, and hides no lower face.
  std::vector<Vertex> lifted{{0, 0, kApex}};
  lifted.reserve(points.size() + 1);
  for (const auto& point : points) {
    const std::int64_t x = std::llround((point[0] - mean[0]) / size * kPlaneSteps);
    const std::int64_t y = std::llround((point[1] - mean[1]) / size * kPlaneSteps);
    lifted.push_back({x, y, x * x + y * y});
  }
  std::vector<Triangle> out;
  for (const auto& [a, b, c] : convex_hull(lifted)) {
    if (a == 0 || b == 0 || c == 0 || cross(lifted[a], lifted[b], lifted[c])[2] >= 0) continue;  // not seen from below
    out.push_back({a - 1, c - 1, b - 1});
  }
  return out;
}

std::vector<Triangle> sphere_triangles(std::span<const std::array<double, 3>> directions) {
  std::vector<Vertex> points;
  points.reserve(directions.size());
  for (const auto& d : directions) {
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(length > 0) || !std::isfinite(length)) return {};
    Vertex point{};
    for (std::size_t i = 0; i < 3; ++i) point.at(i) = std::llround(d.at(i) / length * kSphereSteps);
    points.push_back(point);
  }
  return convex_hull(points);
}

}  // namespace core
}  // namespace percuss
