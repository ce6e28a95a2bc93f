#include "pipeline/survey_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxNamed = 8;
// Points at one angle are a line along the tube. Points around the tube differ by more than kMaxArc_rad.
constexpr double kMinArc_rad = 0.1 * kDegree_rad, kMaxArc_rad = 10 * kDegree_rad;

std::set<int> numbers_of(const acquire::Geometry& geometry) {
  std::set<int> out;
  for (const acquire::GeometryPoint& p : geometry.points) out.insert(p.point);
  return out;
}

// Gives the points the numbers 0, 1, … in the order of their files. Points without a file follow.
void number_as_files(acquire::Geometry& geometry, const std::vector<int>& numbers) {
  std::map<int, int> point_of;
  for (const int number : numbers) point_of.emplace(number, static_cast<int>(point_of.size()));
  for (const int number : numbers_of(geometry)) point_of.emplace(number, static_cast<int>(point_of.size()));
  acquire::renumber_points(geometry, [&](int number) { return point_of.at(number); });
}

// files_in_order: the order of the files decides, although their names have numbers.
Warning files_in_order(const std::vector<std::string>& files, int first) {
  Warning warning{"files_in_order",
                  fmt::format("the numbers in the files' names are not those of the geometry: the files are its points "
                              "in their order, {} is point {}",
                              short_file_name(files.front()), first),
                  {"geometry"}};
  return with_remedy(std::move(warning), "name the files by the geometry's numbers to be sure");
}

[[noreturn]] void refuse_names(const std::set<int>& known, const std::vector<std::string>& files,
                               const std::string& where) {
  const std::vector<int> numbers = numbers_in_names(files, known).value_or(std::vector<int>{});
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!known.contains(numbers[i])) unknown.push_back(i);
  }
  const std::string more = unknown.size() > 1 ? fmt::format(", and those of {} more files", unknown.size() - 1) : "";
  throw InputError(
      fmt::format("the geometry lacks point {}, the number in the name of {}{}", numbers.at(unknown.front()),
                  short_file_name(files.at(unknown.front())), more),
      where,
      "add it, or name the files by the geometry's numbers; to take the files in their order, join them to "
      "one record first",
      {"geometry", "convert.files"});
}

}  // namespace

MatchedPoints match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured,
                                  const std::vector<std::string>& files) {
  MatchedPoints out;
  if (geometry.unit_assumed) {
    out.warnings.push_back(
        {"geometry_unit_assumed", "the geometry states no unit: its lengths are taken as m", {"geometry"}});
  }
  const std::set<int> stated = numbers_of(geometry);
  out.numbers = geometry_numbers(stated, measured, files);
  std::vector<int> before;
  for (const acquire::GeometryPoint& p : geometry.points) before.push_back(p.point);
  const bool from_one = out.numbers == GeometryNumbers::from_one;
  if (out.numbers == GeometryNumbers::file_names) number_as_files(geometry, numbers_in_names(files, stated).value());
  if (from_one) acquire::shift_points(geometry, -1);
  for (std::size_t i = 0; i < before.size(); ++i) out.stated[geometry.points[i].point] = before[i];
  const bool in_order = from_one || out.numbers == GeometryNumbers::record;
  if (in_order && out.stated.contains(0) && numbers_in_names(files, stated)) {
    out.warnings.push_back(files_in_order(files, out.stated.at(0)));
  } else if (from_one) {
    out.warnings.push_back({"points_from_one",
                            fmt::format("the geometry numbers its points from {}, the record from {}: one is "
                                        "subtracted from the geometry's",
                                        *stated.begin(), *measured.begin()),
                            {"geometry"}});
  }
  return out;
}

void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where,
                    const MatchedPoints& matched, const std::vector<std::string>& files) {
  const std::set<int> known = numbers_of(geometry);
  if (matched.numbers == GeometryNumbers::contradicted) refuse_names(known, files, where);
  std::vector<int> missing, missing_from_one;
  for (const int point : measured) {
    if (!known.contains(point)) missing.push_back(point);
    if (!known.contains(point + 1)) missing_from_one.push_back(point + 1);
  }
  if (missing.empty()) return;
  const bool may_count_from_one = !known.contains(0) && measured.contains(0) &&
                                  2 * missing_from_one.size() < measured.size() && !missing_from_one.empty();
  if (!files.empty()) {
    const int lacked = may_count_from_one ? missing_from_one.front() : missing.front();
    const auto file = static_cast<std::size_t>(may_count_from_one ? lacked - 1 : lacked);
    throw InputError(fmt::format("the geometry lacks point {}: each of the {} files is taken as a point, and {} is "
                                 "point {}",
                                 lacked, files.size(), short_file_name(files.at(file)), lacked),
                     where,
                     "add it; if several files are hits of one point, name them P1_hit1, P1_hit2, P2_hit1 and so on, "
                     "or join the files of each point first",
                     {"geometry", "convert.files"});
  }
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
                                    const MatchedPoints& matched, std::size_t files) {
  std::vector<int> missing;
  for (const acquire::GeometryPoint& p : geometry.points) {
    if (measured.contains(p.point)) continue;
    const auto stated = matched.stated.find(p.point);
    missing.push_back(stated != matched.stated.end() ? stated->second : p.point);
  }
  if (missing.empty()) return {};
  const std::string names =
      limited_list(missing.size(), kMaxNamed, [&](std::size_t i) { return std::to_string(missing[i]); });
  Warning warning{"missing_points", fmt::format("{} of the geometry's {} points were not measured: {}", missing.size(),
                                                geometry.points.size(), names)};
  if (matched.numbers == GeometryNumbers::file_names) {
    warning.message += "; each file is the point of the number in its name";
  } else if (files > 1) {
    warning.message +=
        "; files taken as points are numbered in the order of their names, without gaps: if the file of one is "
        "missing, all later points are at wrong places";
    warning.options.emplace_back("files");
    warning.severity = warnings::Severity::warn;
    warning = with_remedy(std::move(warning), "name the files by the geometry's numbers");
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
