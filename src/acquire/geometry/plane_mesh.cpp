#include "acquire/geometry/plane_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/math/convex_hull.hpp"
#include "core/math/statistics.hpp"

namespace percuss::acquire {
namespace {

constexpr double kSameGridLine = 0.01;  // of the extent: coordinates within it are of one row or column
constexpr double kMinOccupied = 0.6;    // of the grid's places
constexpr double kMaxOutlineEdge = 3;   // of the median edge

using PlanePoints = std::span<const std::array<double, 2>>;
using Edge = std::array<std::size_t, 2>;

Edge undirected(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// The number of the row or column of each point along a coordinate, ascending.
std::vector<std::size_t> grid_lines_along(PlanePoints points, std::size_t coordinate) {
  std::vector<std::size_t> order(points.size()), line(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto value = [&](std::size_t i) { return points[i].at(coordinate); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return value(a) < value(b); });
  const double gap = kSameGridLine * (value(order.back()) - value(order.front()));
  for (std::size_t i = 1; i < order.size(); ++i)
    line[order[i]] = line[order[i - 1]] + (value(order[i]) - value(order[i - 1]) > gap ? 1 : 0);
  return line;
}

double length_of(PlanePoints points, const Edge& edge) {
  return std::hypot(points[edge[0]][0] - points[edge[1]][0], points[edge[0]][1] - points[edge[1]][1]);
}

// The triangles at each edge.
using EdgeTriangles = std::map<Edge, std::vector<std::size_t>>;

EdgeTriangles triangles_at_edges(const std::vector<Triangle>& triangles) {
  EdgeTriangles out;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) out[undirected(triangles[t].at(i), triangles[t].at((i + 1) % 3))].push_back(t);
  }
  return out;
}

// Removes triangles whose outline edge is longer than kMaxOutlineEdge medians, the longest edge first. A triangle stays
// if its third corner is on the outline, so that the outline remains one closed line through all of its points.
std::vector<Triangle> without_long_outline(PlanePoints points, std::vector<Triangle> triangles) {
  EdgeTriangles at = triangles_at_edges(triangles);
  std::vector<double> lengths;
  std::set<std::pair<double, Edge>> outline;
  std::set<std::size_t> outline_points;
  for (const auto& [edge, members] : at) {
    lengths.push_back(length_of(points, edge));
    if (members.size() != 1) continue;
    outline.emplace(lengths.back(), edge);
    outline_points.insert(edge.begin(), edge.end());
  }
  const double limit = kMaxOutlineEdge * median(std::move(lengths));
  std::vector<bool> removed(triangles.size());
  while (!outline.empty() && outline.rbegin()->first > limit) {
    const Edge edge = outline.rbegin()->second;
    outline.erase(std::prev(outline.end()));
    const std::size_t t = at[edge].front();
    const auto inner = std::find_if(triangles[t].begin(), triangles[t].end(),
                                    [&](std::size_t p) { return p != edge[0] && p != edge[1]; });
    if (!outline_points.insert(*inner).second) continue;
    removed[t] = true;
    for (const std::size_t end : edge) {
      const Edge next = undirected(end, *inner);
      std::erase(at[next], t);
      outline.emplace(length_of(points, next), next);
    }
  }
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!removed[t]) kept.push_back(triangles[t]);
  }
  return kept;
}

}  // namespace

std::optional<StructureMesh> grid_mesh(PlanePoints points) {
  if (points.size() < 4) return std::nullopt;
  const std::vector<std::size_t> column = grid_lines_along(points, 0), row = grid_lines_along(points, 1);
  using GridPlace = std::array<std::size_t, 2>;
  std::map<GridPlace, std::size_t> at;  // the point in each column and row
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!at.emplace(GridPlace{column[i], row[i]}, i).second) return std::nullopt;
  }
  const std::size_t columns = *std::max_element(column.begin(), column.end()) + 1;
  const std::size_t rows = *std::max_element(row.begin(), row.end()) + 1;
  const double places = static_cast<double>(columns) * static_cast<double>(rows);
  if (columns < 2 || rows < 2 || static_cast<double>(points.size()) < kMinOccupied * places) return std::nullopt;
  StructureMesh mesh{.layout = PointLayout::grid, .lines = {}, .faces = {}, .normals = {}};
  const auto find = [&](std::size_t c, std::size_t r) { return at.find({c, r}); };
  for (const auto& [place, point] : at) {
    const auto right = find(place[0] + 1, place[1]), up = find(place[0], place[1] + 1);
    const auto across = find(place[0] + 1, place[1] + 1);
    if (right != at.end()) mesh.lines.push_back({point, right->second});
    if (up != at.end()) mesh.lines.push_back({point, up->second});
    if (right != at.end() && up != at.end() && across != at.end())
      mesh.faces.push_back({point, right->second, across->second, up->second});
  }
  return mesh;
}

StructureMesh triangle_mesh(PlanePoints points) {
  StructureMesh mesh{.layout = PointLayout::plane, .lines = {}, .faces = {}, .normals = {}};
  for (const Triangle& corners : without_long_outline(points, delaunay_triangles(points)))
    mesh.faces.emplace_back(corners.begin(), corners.end());
  mesh.lines = edges_of(mesh.faces);
  return mesh;
}

}  // namespace percuss::acquire
