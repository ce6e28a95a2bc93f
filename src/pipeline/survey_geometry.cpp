#include "pipeline/survey_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percuss::pipeline {

std::vector<Warning> fit_geometry(acquire::Geometry& geometry, const std::set<int>& measured) {
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
  warnings.push_back(
      {"points_from_one",
       fmt::format("the geometry numbers its points from {}, the record from {}: one is subtracted from the geometry's",
                   *known.begin(), *measured.begin()),
       {"geometry"}});
  return warnings;
}

}  // namespace percuss::pipeline
