#include "acquire/geometry/structure_mesh.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "acquire/geometry/plane_mesh.hpp"
#include "core/math/convex_hull.hpp"

namespace percuss::acquire {
namespace {

constexpr std::size_t kMaxMeshPoints = 2000;
constexpr double kThin = 1e-6;         // extent across a line, of its length: rounding
constexpr double kMaxAside = 0.2;      // extent across a line, of the smallest distance between neighbours
constexpr double kFlat = 0.1;          // extent across a plane, of its width
constexpr double kMinProjected = 0.2;  // the part of a distance that a projection on a plane must keep
constexpr double kUpright = 0.9;       // cosine from which a line runs along z

using MeshPoints = std::span<const std::array<double, 3>>;
using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& at) { return {at[0], at[1], at[2]}; }
Vector3d middle_of(MeshPoints points) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& p : points) sum += vector_of(p);
  return sum / static_cast<double>(points.size());
}
std::array<double, 3> array_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

// Axes along which the points lie, longest extent first. They are the coordinate axes if the points lie along these, so
// that a plate in x and y keeps its rows; else the principal axes.
struct MeshAxes {
  Vector3d middle = Vector3d::Zero();
  std::array<Vector3d, 3> axis;
  std::array<double, 3> extent{};
};

MeshAxes axes_from(MeshPoints points, const Vector3d& middle, const std::array<Vector3d, 3>& axes) {
  MeshAxes out{.middle = middle, .axis = {}};
  std::array<std::pair<double, std::size_t>, 3> order;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = 0, high = 0;
    for (const auto& p : points) {
      const double along = axes.at(i).dot(vector_of(p) - middle);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    order.at(i) = {high - low, i};
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 0; i < 3; ++i) {
    out.extent.at(i) = order.at(i).first;
    out.axis.at(i) = axes.at(order.at(i).second);
  }
  return out;
}

// Points form a straight line if their extent across it is mere rounding, or small compared with the smallest distance
// between neighbours along it.
bool is_straight(MeshPoints points, const MeshAxes& axes) {
  std::vector<double> along;
  along.reserve(points.size());
  for (const auto& p : points) along.push_back(axes.axis[0].dot(vector_of(p)));
  std::sort(along.begin(), along.end());
  double gap = axes.extent[0];
  for (std::size_t i = 1; i < along.size(); ++i) gap = std::min(gap, along[i] - along[i - 1]);
  return axes.extent[1] <= std::max(kThin * axes.extent[0], kMaxAside * gap);
}

bool is_flat(const MeshAxes& axes) { return axes.extent[2] <= kFlat * axes.extent[1]; }

MeshAxes axes_of(MeshPoints points) {
  const Vector3d middle = middle_of(points);
  MeshAxes along_xyz = axes_from(points, middle, {Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()});
  if (is_straight(points, along_xyz)) return along_xyz;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& p : points) spread += (vector_of(p) - middle) * (vector_of(p) - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  std::array<Vector3d, 3> principal;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3d axis = solver.eigenvectors().col(static_cast<Eigen::Index>(2 - i));
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    principal.at(i) = axis[largest] < 0 ? Vector3d(-axis) : axis;
  }
  MeshAxes along_principal = axes_from(points, middle, principal);
  return is_flat(along_xyz) && !is_straight(points, along_principal) ? along_xyz : along_principal;
}

std::vector<std::array<double, 2>> projected(MeshPoints points, const MeshAxes& axes) {
  std::vector<std::array<double, 2>> out;
  out.reserve(points.size());
  for (const auto& p : points) {
    const Vector3d from_middle = vector_of(p) - axes.middle;
    out.push_back({axes.axis[0].dot(from_middle), axes.axis[1].dot(from_middle)});
  }
  return out;
}

// Whether the projection brings two distant points close together, as the walls of a box seen from above.
bool folds(MeshPoints points, const std::vector<std::array<double, 2>>& plane) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      const double apart = (vector_of(points[i]) - vector_of(points[k])).norm();
      if (std::hypot(plane[i][0] - plane[k][0], plane[i][1] - plane[k][1]) < kMinProjected * apart) return true;
    }
  }
  return false;
}

StructureMesh line_mesh(MeshPoints points, const MeshAxes& axes) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto along = [&](std::size_t i) { return axes.axis[0].dot(vector_of(points[i])); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  StructureMesh mesh{.layout = PointLayout::line, .lines = {}, .faces = {}, .normals = {}};
  for (std::size_t i = 1; i < order.size(); ++i) mesh.lines.push_back({order[i - 1], order[i]});
  const Vector3d up = std::abs(axes.axis[0].z()) > kUpright ? Vector3d::UnitX() : Vector3d::UnitZ();
  const Vector3d normal = (up - up.dot(axes.axis[0]) * axes.axis[0]).normalized();
  mesh.normals.assign(points.size(), array_of(normal));
  return mesh;
}

// A closed surface of triangles between the directions of the points from the middle. All extents are scaled to one
// first, so that a long box counts as a cube.
StructureMesh surface_mesh(MeshPoints points, const MeshAxes& axes) {
  std::vector<std::array<double, 3>> directions;
  directions.reserve(points.size());
  for (const auto& p : points) {
    std::array<double, 3> direction{};
    for (std::size_t i = 0; i < 3; ++i)
      direction.at(i) = axes.axis.at(i).dot(vector_of(p) - axes.middle) / axes.extent.at(i);
    directions.push_back(direction);
  }
  StructureMesh mesh{.layout = PointLayout::surface, .lines = {}, .faces = {}, .normals = {}};
  for (const Triangle& t : sphere_triangles(directions)) mesh.faces.emplace_back(t.begin(), t.end());
  mesh.lines = edges_of(mesh.faces);
  if (mesh.faces.empty()) mesh.layout = PointLayout::scattered;
  mesh.normals = normals_of(points, mesh.faces, {0, 0, 1});
  return mesh;
}

}  // namespace

std::vector<std::array<std::size_t, 2>> edges_of(const std::vector<std::vector<std::size_t>>& faces) {
  std::set<std::array<std::size_t, 2>> edges;
  for (const auto& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t a = face[i], b = face[(i + 1) % face.size()];
      if (a != b) edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return {edges.begin(), edges.end()};
}

std::vector<std::array<double, 3>> normals_of(MeshPoints points, const std::vector<std::vector<std::size_t>>& faces,
                                              const std::array<double, 3>& towards) {
  const Vector3d middle = middle_of(points);
  std::vector<Vector3d> sums(points.size(), Vector3d::Zero());
  Vector3d all = Vector3d::Zero();
  double volume = 0;  // six times
  std::map<std::array<std::size_t, 2>, int> faces_at_edge;
  for (const auto& face : faces) {
    Vector3d normal = Vector3d::Zero();  // as long as twice the area
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t a = face[i], b = face[(i + 1) % face.size()];
      normal += (vector_of(points[a]) - middle).cross(vector_of(points[b]) - middle);
      ++faces_at_edge[{std::min(a, b), std::max(a, b)}];
    }
    volume += normal.dot(vector_of(points[face.front()]) - middle);
    all += normal;
    for (const std::size_t corner : face) sums[corner] += normal;
  }
  const bool closed =
      std::all_of(faces_at_edge.begin(), faces_at_edge.end(), [](const auto& edge) { return edge.second > 1; });
  const double sense = closed ? volume : all.dot(vector_of(towards));
  std::vector<std::array<double, 3>> out;
  out.reserve(points.size());
  for (const Vector3d& sum : sums)
    out.push_back(sum.norm() > 0 ? array_of(sum.normalized() * (sense < 0 ? -1 : 1)) : towards);
  return out;
}

StructureMesh structure_mesh(MeshPoints points) {
  StructureMesh none;
  none.normals.assign(points.size(), {0, 0, 1});
  const auto finite = [](const std::array<double, 3>& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  if (points.size() < 2 || points.size() > kMaxMeshPoints || !std::all_of(points.begin(), points.end(), finite))
    return none;
  const MeshAxes axes = axes_of(points);
  if (!(axes.extent[0] > 0) || !std::isfinite(axes.extent[0])) return none;
  if (is_straight(points, axes)) return line_mesh(points, axes);
  const auto plane = projected(points, axes);
  if (!is_flat(axes) || folds(points, plane)) return axes.extent[2] > 0 ? surface_mesh(points, axes) : none;
  StructureMesh mesh = grid_mesh(plane).value_or(StructureMesh{});
  if (mesh.lines.empty()) mesh = triangle_mesh(plane);
  mesh.normals = normals_of(points, mesh.faces, array_of(axes.axis[2]));
  return mesh;
}

}  // namespace percuss::acquire
