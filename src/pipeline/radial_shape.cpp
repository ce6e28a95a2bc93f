#include "pipeline/radial_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace percuss::pipeline {
namespace {

using acquire::Direction;

struct Component {
  identify::ShapePlace value;
  std::optional<Direction> along;
};
using Components = std::vector<Component>;

double product(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction normal_at(const acquire::GeometryPoint& point, std::size_t axis) {
  Direction out{};
  out.at((axis + 1) % 3) = std::cos(point.angle_rad);
  out.at((axis + 2) % 3) = std::sin(point.angle_rad);
  return out;
}

// Equation (1), for components that all have a direction; nothing where Σ c_i d_i is not the normal.
std::optional<identify::ShapePlace> combined(const Components& components, const Direction& normal) {
  constexpr double kRounding = 1e-6;
  Direction rest = normal;
  identify::ShapePlace out = components.front().value;
  double variance = 0;
  out.value = 0;
  out.sets_scale = false;
  for (const Component& one : components) {
    const double cosine = product(*one.along, normal);
    for (std::size_t i = 0; i < 3; ++i) rest.at(i) -= cosine * one.along->at(i);
    out.value += cosine * one.value.value;
    variance += std::pow(cosine * one.value.std, 2);
  }
  out.std = std::sqrt(variance);
  return product(rest, rest) < kRounding * kRounding ? std::optional(out) : std::nullopt;
}

std::optional<identify::ShapePlace> radial(const Components& components, const Direction& normal) {
  constexpr double kMinCosine = 1 / std::numbers::sqrt2 - 1e-6;
  for (const Component& one : components) {
    if (!one.along) return one.value;
  }
  if (components.size() > 1) {
    if (const auto both = combined(components, normal)) return both;
  }
  const auto nearest = std::max_element(components.begin(), components.end(), [&](const auto& a, const auto& b) {
    return std::abs(product(*a.along, normal)) < std::abs(product(*b.along, normal));
  });
  const double cosine = product(*nearest->along, normal);
  if (std::abs(cosine) < kMinCosine) return std::nullopt;
  identify::ShapePlace out = nearest->value;
  if (cosine < 0) out.value = -out.value;
  return out;
}

bool all_along_one_line(const std::map<int, Components>& places) {
  constexpr double kSameLine = 1 - 1e-6;
  const Direction* first = nullptr;
  for (const auto& [number, components] : places) {
    for (const Component& one : components) {
      if (!one.along) return false;
      if (first == nullptr) first = &*one.along;
      if (std::abs(product(*first, *one.along)) < kSameLine) return false;
    }
  }
  return true;
}

}  // namespace

identify::ModeShape radial_shape(const identify::ModeShape& shape, const std::vector<acquire::PointMotion>& motions,
                                 const acquire::Geometry& geometry) {
  std::map<int, Components> places;
  for (identify::ShapePlace value : shape.places) {
    const int point = static_cast<int>(value.point);
    const acquire::PointMotion* const motion = acquire::find_motion(motions, point, value.channel);
    const int number = acquire::place_of_point(motions, point);
    value.point = static_cast<std::size_t>(number);
    places[number].push_back({value, motion != nullptr ? motion->along : std::nullopt});
  }
  identify::ModeShape out = shape, plain = shape;
  out.places.clear();
  plain.places.clear();
  bool everywhere = true;
  for (const acquire::GeometryPoint& point : geometry.points) {
    const auto at = places.find(point.point);
    if (at == places.end()) continue;
    plain.places.push_back(at->second.front().value);
    const auto value = radial(at->second, normal_at(point, geometry.axis));
    if (value) out.places.push_back(*value);
    everywhere = everywhere && value.has_value();
  }
  if (!everywhere && all_along_one_line(places)) out = plain;
  std::sort(out.places.begin(), out.places.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
  return out;
}

}  // namespace percuss::pipeline
