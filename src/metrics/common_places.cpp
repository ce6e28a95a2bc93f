#include "metrics/common_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace percuss::metrics {
namespace {

using Coordinates = std::array<double, 3>;

constexpr double kOfExtent = 0.01;  // points are marked by hand, to some mm on a structure of a metre
constexpr double kOfSpacing = 0.25;
constexpr double kParallel = 0.95;                // |cosine|: 18°
constexpr std::size_t kMaxCompared = 10'000'000;  // pairs of points, which bounds time and memory

std::set<int> points_of(const ComparedDocument& document) {
  std::set<int> points;
  for (const ComparedMode& mode : document.modes) {
    for (const auto& [place, component] : mode.shape) points.insert(place.first);
  }
  return points;
}

const ComparedPlace* place_at(const ComparedDocument& document, int point) {
  const auto at = document.places.find(point);
  return at == document.places.end() ? nullptr : &at->second;
}

int number_of(const ComparedDocument& document, int point) {
  const ComparedPlace* place = place_at(document, point);
  return place != nullptr ? place->number : point;
}

// The points with their coordinates; nothing if one has none.
std::optional<std::vector<std::pair<int, Coordinates>>> coordinates_of(const ComparedDocument& document,
                                                                       const std::set<int>& points) {
  std::vector<std::pair<int, Coordinates>> out;
  for (const int point : points) {
    const ComparedPlace* place = place_at(document, point);
    if (place == nullptr || !place->xyz_m) return std::nullopt;
    out.emplace_back(point, *place->xyz_m);
  }
  return out;
}

double distance(const Coordinates& a, const Coordinates& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The largest distance at which two points are at one place.
double tolerance_m(const std::vector<std::pair<int, Coordinates>>& points) {
  double extent_m = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), [&](const auto& x, const auto& y) {
      return x.second.at(axis) < y.second.at(axis);
    });
    extent_m = std::max(extent_m, highest->second.at(axis) - lowest->second.at(axis));
  }
  double spacing_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double apart_m = distance(points[i].second, points[k].second);
      if (apart_m > 0) spacing_m = std::min(spacing_m, apart_m);
    }
  }
  return std::min(kOfExtent * extent_m, kOfSpacing * spacing_m);
}

// The sign of b's values in the direction of a; nothing where the directions are not parallel.
std::optional<double> common_sign(const ComparedPlace& a, const ComparedPlace& b) {
  if (!a.direction || !b.direction) return 1;
  const Coordinates &x = *a.direction, &y = *b.direction;
  const double cosine =
      (x[0] * y[0] + x[1] * y[1] + x[2] * y[2]) / (std::hypot(x[0], x[1], x[2]) * std::hypot(y[0], y[1], y[2]));
  if (!(std::abs(cosine) >= kParallel)) return std::nullopt;
  return cosine < 0 ? -1 : 1;
}

std::map<int, MatchedPoint> by_coordinates(const ComparedDocument& a, const ComparedDocument& b,
                                           const std::vector<std::pair<int, Coordinates>>& of_a,
                                           const std::vector<std::pair<int, Coordinates>>& of_b) {
  struct Candidate {
    double apart_m = 0;
    int a = 0, b = 0;
    double sign = 1;
  };
  if (of_a.size() > kMaxCompared / of_b.size()) return {};
  const double tolerance = tolerance_m(of_a.size() <= of_b.size() ? of_a : of_b);
  if (!(tolerance > 0)) return {};  // all points are at one place
  std::vector<Candidate> candidates;
  for (const auto& [point_a, xyz_a] : of_a) {
    for (const auto& [point_b, xyz_b] : of_b) {
      const double apart_m = distance(xyz_a, xyz_b);
      if (apart_m > tolerance) continue;
      const auto sign = common_sign(*place_at(a, point_a), *place_at(b, point_b));
      if (sign) candidates.push_back({.apart_m = apart_m, .a = point_a, .b = point_b, .sign = *sign});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.apart_m < y.apart_m; });
  std::map<int, MatchedPoint> pairs;
  std::set<int> taken;
  for (const Candidate& one : candidates) {
    if (taken.contains(one.a) || pairs.contains(one.b)) continue;
    pairs[one.b] = {.point = one.a, .sign = one.sign};
    taken.insert(one.a);
  }
  return pairs;
}

// The points by their displayed numbers. If several points have one number, the first.
std::map<int, int> points_by_number(const ComparedDocument& document, const std::set<int>& points) {
  std::map<int, int> out;
  for (const int point : points) out.try_emplace(number_of(document, point), point);
  return out;
}

// Whether the numbers have no gap and begin at `first`.
bool counts_from(const std::map<int, int>& numbers, int first) {
  return !numbers.empty() && numbers.begin()->first == first &&
         numbers.rbegin()->first - first + 1 == static_cast<int>(numbers.size());
}

// Matches the points by their numbers or their sequence.
void by_number(const ComparedDocument& a, const ComparedDocument& b, const std::set<int>& points_a,
               const std::set<int>& points_b, CommonPlaces& out) {
  const std::map<int, int> numbers_a = points_by_number(a, points_a), numbers_b = points_by_number(b, points_b);
  const auto pair = [&](int point_a, int point_b) {
    const ComparedPlace *place_a = place_at(a, point_a), *place_b = place_at(b, point_b);
    const auto sign = place_a != nullptr && place_b != nullptr ? common_sign(*place_a, *place_b) : 1;
    if (sign) out.of_b[point_b] = {.point = point_a, .sign = *sign};
  };
  const bool shifted =
      numbers_a.size() == numbers_b.size() && ((counts_from(numbers_a, 0) && counts_from(numbers_b, 1)) ||
                                               (counts_from(numbers_a, 1) && counts_from(numbers_b, 0)));
  if (shifted) {
    out.by = PlacesMatchedBy::sequence;
    for (auto x = numbers_a.begin(), y = numbers_b.begin(); x != numbers_a.end(); ++x, ++y) pair(x->second, y->second);
    return;
  }
  for (const auto& [number, point] : numbers_b) {
    const auto same = numbers_a.find(number);
    if (same != numbers_a.end()) pair(same->second, point);
  }
}

}  // namespace

const char* name_of(PlacesMatchedBy by) {
  switch (by) {
    case PlacesMatchedBy::coordinates:
      return "coordinates";
    case PlacesMatchedBy::numbers:
      return "numbers";
    case PlacesMatchedBy::sequence:
      return "sequence";
  }
  return "";
}

CommonPlaces common_places(const ComparedDocument& a, const ComparedDocument& b) {
  const std::set<int> points_a = points_of(a), points_b = points_of(b);
  CommonPlaces out{.points_a = points_a.size(), .points_b = points_b.size()};
  std::map<int, MatchedPoint> by_place;
  if (points_a.size() >= kMinPlaces && points_b.size() >= kMinPlaces) {
    const auto of_a = coordinates_of(a, points_a), of_b = coordinates_of(b, points_b);
    if (of_a && of_b) {
      by_place = by_coordinates(a, b, *of_a, *of_b);
      out.coordinates_differ = true;
    }
  }
  by_number(a, b, points_a, points_b, out);
  if (by_place.size() < std::max(kMinPlaces, out.of_b.size())) return out;
  out.by = PlacesMatchedBy::coordinates;
  out.of_b = std::move(by_place);
  out.coordinates_differ = false;
  return out;
}

ComparedDocument at_places_of_first(ComparedDocument b, const CommonPlaces& common) {
  for (ComparedMode& mode : b.modes) {
    std::map<std::pair<int, int>, ComparedMode::Component> shape;
    for (const auto& [place, component] : mode.shape) {
      const auto matched = common.of_b.find(place.first);
      if (matched == common.of_b.end()) continue;
      shape[{matched->second.point, place.second}] = {.value = matched->second.sign * component.value,
                                                      .std = component.std};
    }
    mode.shape = std::move(shape);
  }
  return b;
}

}  // namespace percuss::metrics
