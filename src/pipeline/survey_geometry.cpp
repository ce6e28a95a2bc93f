#include "pipeline/survey_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace percuss::pipeline {

std::vector<Warning> match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured,
                                         const std::vector<std::size_t>& driving) {
  std::vector<Warning> warnings;
  if (geometry.unit_assumed) {
    warnings.push_back(
        {"geometry_unit_assumed", "the geometry states no unit: its lengths are taken as m", {"geometry"}});
  }
  std::set<int> known;
  for (const acquire::GeometryPoint& p : geometry.points) known.insert(p.point);
  const auto lacks = [&](int offset) {
    return std::any_of(measured.begin(), measured.end(), [&](int point) { return !known.contains(point + offset); });
  };
  if (!lacks(0) || lacks(1) || known.contains(0)) return warnings;
  acquire::shift_points(geometry, -1);
  Warning warning{
      "points_from_one",
      fmt::format("the geometry numbers its points from {}, the record from {}: one is subtracted from the geometry's",
                  *known.begin(), *measured.begin()),
      {"geometry"}};
  for (const std::size_t point : driving) {
    warning.message += fmt::format("{} driving point {} is the geometry's point {}",
                                   point == driving.front() ? ", so that" : ",", point, point + 1);
  }
  if (!driving.empty()) warning.options.emplace_back("driving_point");
  warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace percuss::pipeline
