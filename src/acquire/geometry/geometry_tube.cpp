#include <algorithm>
#include <array>
#include <cmath>

#include "acquire/geometry/geometry.hpp"

namespace percuss::acquire {
namespace {

constexpr double kMaxDeviation = 0.1;           // of a radius, over the mean radius of its ring
constexpr double kSameRing = 2e-3;              // of the length along the axis
constexpr std::size_t kMinTubePoints = 3;       // of each ring, where there are several rings
constexpr std::size_t kMinPointsOnOneRing = 5;  // of a single ring: the four corners of a plate are no ring

struct Tube {
  std::size_t axis = 0;
  double deviation = 0;            // largest relative deviation of a radius from the mean of its ring
  std::array<double, 2> middle{};  // centre, across the axis
};

// The two coordinates across the axis, in right-handed order.
std::array<std::size_t, 2> across(std::size_t axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

// Groups the points into rings, as indices.
std::vector<std::vector<std::size_t>> rings_along(const std::vector<GeometryPoint>& points, std::size_t axis) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto along = [&](std::size_t i) { return (*points[i].xyz_m)[axis]; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  const double gap = kSameRing * (along(order.back()) - along(order.front()));
  std::vector<std::vector<std::size_t>> rings;
  for (const std::size_t i : order) {
    if (rings.empty() || along(i) - along(rings.back().back()) > gap) rings.emplace_back();
    rings.back().push_back(i);
  }
  return rings;
}

double radius_about(const GeometryPoint& point, const Tube& tube) {
  const auto [u, v] = across(tube.axis);
  return std::hypot((*point.xyz_m)[u] - tube.middle[0], (*point.xyz_m)[v] - tube.middle[1]);
}

// The tube about this axis; nothing when the points do not form rings.
std::optional<Tube> tube_about(const std::vector<GeometryPoint>& points, std::size_t axis) {
  Tube tube{.axis = axis};
  const auto [u, v] = across(axis);
  for (const GeometryPoint& p : points) {
    tube.middle[0] += (*p.xyz_m)[u] / static_cast<double>(points.size());
    tube.middle[1] += (*p.xyz_m)[v] / static_cast<double>(points.size());
  }
  const auto rings = rings_along(points, axis);
  for (const auto& ring : rings) {
    if (ring.size() < (rings.size() > 1 ? kMinTubePoints : kMinPointsOnOneRing)) return std::nullopt;
    double mean = 0;
    for (const std::size_t i : ring) mean += radius_about(points[i], tube) / static_cast<double>(ring.size());
    if (!(mean > 0)) return std::nullopt;
    for (const std::size_t i : ring)
      tube.deviation = std::max(tube.deviation, std::abs(radius_about(points[i], tube) / mean - 1));
  }
  if (tube.deviation > kMaxDeviation) return std::nullopt;
  return tube;
}

}  // namespace

void tube_from_coordinates(Geometry& geometry) {
  const bool all = std::all_of(geometry.points.begin(), geometry.points.end(),
                               [](const GeometryPoint& p) { return p.xyz_m.has_value(); });
  if (!all || geometry.points.empty()) return;
  std::optional<Tube> best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto tube = tube_about(geometry.points, axis);
    if (tube && (!best || tube->deviation < best->deviation)) best = tube;
  }
  if (!best) return;
  const auto [u, v] = across(best->axis);
  for (GeometryPoint& p : geometry.points) {
    p.position_m = (*p.xyz_m)[best->axis];
    p.angle_rad = std::atan2((*p.xyz_m)[v] - best->middle[1], (*p.xyz_m)[u] - best->middle[0]);
    p.radius_m = radius_about(p, *best);
  }
  geometry.tube = true;
  geometry.axis = best->axis;
}

}  // namespace percuss::acquire
