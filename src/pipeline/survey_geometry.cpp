#include "pipeline/survey_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/io/counted_words.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxNamed = 8;
// Points at one angle are a line along the tube. Points around the tube differ by more than kMaxArc_rad.
constexpr double kMinArc_rad = 0.1 * kDegree_rad, kMaxArc_rad = 10 * kDegree_rad;

}  // namespace

bool counts_from_one(const acquire::Geometry& geometry, const std::set<int>& measured) {
  std::set<int> known;
  for (const acquire::GeometryPoint& p : geometry.points) known.insert(p.point);
  const auto lacks = [&](int offset) {
    return std::any_of(measured.begin(), measured.end(), [&](int point) { return !known.contains(point + offset); });
  };
  return lacks(0) && !lacks(1) && !known.contains(0);
}

std::vector<Warning> match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured) {
  std::vector<Warning> warnings;
  if (geometry.unit_assumed) {
    warnings.push_back(
        {"geometry_unit_assumed", "the geometry states no unit: its lengths are taken as m", {"geometry"}});
  }
  if (!counts_from_one(geometry, measured)) return warnings;
  int lowest = geometry.points.front().point;
  for (const acquire::GeometryPoint& p : geometry.points) lowest = std::min(lowest, p.point);
  acquire::shift_points(geometry, -1);
  warnings.push_back(
      {"points_from_one",
       fmt::format("the geometry numbers its points from {}, the record from {}: one is subtracted from the geometry's",
                   lowest, *measured.begin()),
       {"geometry"}});
  return warnings;
}

void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where) {
  std::set<int> known;
  for (const acquire::GeometryPoint& p : geometry.points) known.insert(p.point);
  std::vector<int> missing, missing_from_one;
  for (const int point : measured) {
    if (!known.contains(point)) missing.push_back(point);
    if (!known.contains(point + 1)) missing_from_one.push_back(point + 1);
  }
  if (missing.empty()) return;
  const bool may_count_from_one = !known.contains(0) && measured.contains(0) &&
                                  2 * missing_from_one.size() < measured.size() && !missing_from_one.empty();
  const std::string or_from_one =
      may_count_from_one
          ? fmt::format(
                " (point {} if the geometry numbers its points from 1; files taken as points count as one point "
                "each)",
                missing_from_one.front())
          : "";
  throw InputError(fmt::format("the geometry lacks point {}, which was measured", missing.front()), where,
                   fmt::format("add it{}, or use the record's point numbers, {} to {}", or_from_one, *measured.begin(),
                               *measured.rbegin()),
                   {"geometry"});
}

std::vector<Warning> missing_points(const acquire::Geometry& geometry, const std::set<int>& measured,
                                    std::size_t files) {
  std::vector<int> missing;
  for (const acquire::GeometryPoint& p : geometry.points) {
    if (!measured.contains(p.point)) missing.push_back(p.point);
  }
  if (missing.empty()) return {};
  const std::string names =
      limited_list(missing.size(), kMaxNamed, [&](std::size_t i) { return std::to_string(missing[i]); });
  Warning warning{"missing_points", fmt::format("{} of the geometry's {} points were not measured: {}", missing.size(),
                                                geometry.points.size(), names)};
  if (files > 1) {
    warning.message += "; files taken as points are numbered in the order of their names, without gaps";
    warning.options.emplace_back("files");
  }
  return {std::move(warning)};
}

std::vector<Warning> narrow_arc(const acquire::Geometry& geometry) {
  double low = 0, high = 0;
  for (const acquire::GeometryPoint& p : geometry.points) {
    if (&p == &geometry.points.front()) low = high = p.angle_rad;
    low = std::min(low, p.angle_rad);
    high = std::max(high, p.angle_rad);
  }
  if (!geometry.tube || high - low < kMinArc_rad || high - low > kMaxArc_rad) return {};
  return {with_remedy({"narrow_arc",
                       fmt::format("all points lie within {:.2g}° around the tube, which does not tell bending from "
                                   "hoop",
                                   (high - low) * kRadian_deg),
                       {"geometry"}},
                      "give the angles in degrees, or call their column angle_rad; give x, y and z for a plate")};
}

}  // namespace percuss::pipeline
