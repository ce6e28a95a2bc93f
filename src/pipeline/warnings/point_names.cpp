#include "pipeline/warnings/point_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "core/error.hpp"
#include "core/io/counted_words.hpp"
#include "core/io/natural_order.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMaxDigits = 9;  // of a number in a name

// A way in which files can be points.
struct PointsOfFiles {
  std::vector<std::string> paths;     // [points]
  std::vector<std::size_t> point_of;  // [files]
};

// The ways to take the files as this number of points: each file, or each group of files of hits, is one in order.
std::vector<PointsOfFiles> points_of_files(const std::vector<std::string>& paths, std::size_t points) {
  if (paths.size() == points) {
    PointsOfFiles each{.paths = paths, .point_of = {}};
    for (std::size_t i = 0; i < paths.size(); ++i) each.point_of.push_back(i);
    return {std::move(each)};
  }
  std::vector<std::vector<acquire::FilesOfHits>> groupings{acquire::files_of_hits(paths)};
  if (groupings.front().empty()) groupings = acquire::groupings_by_two_numbers(paths);
  std::vector<PointsOfFiles> out;
  for (const std::vector<acquire::FilesOfHits>& groups : groupings) {
    if (groups.size() != points) continue;
    PointsOfFiles one{.paths = {}, .point_of = std::vector<std::size_t>(paths.size())};
    for (std::size_t p = 0; p < groups.size(); ++p) {
      one.paths.push_back(groups[p].stem);
      for (const std::size_t file : groups[p].files) one.point_of[file] = p;
    }
    out.push_back(std::move(one));
  }
  return out;
}

// [names] the number in one part of each name; nothing if two are equal or one is too long.
std::optional<std::vector<int>> different_numbers(const std::vector<NameParts>& parts, std::size_t part) {
  std::vector<int> numbers;
  for (const NameParts& name : parts) {
    if (name[part].size() > kMaxDigits) return std::nullopt;
    numbers.push_back(std::stoi(name[part]));
  }
  const std::set<int> different(numbers.begin(), numbers.end());
  return different.size() == numbers.size() ? std::optional(numbers) : std::nullopt;
}

bool holds_all(const std::set<int>& numbers, const std::vector<int>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](int n) { return numbers.contains(n); });
}

// Whether `numbers` has first, first + 1, … first + count − 1.
bool holds_from(const std::set<int>& numbers, int first, std::size_t count) {
  for (int i = 0; i < static_cast<int>(count); ++i) {
    if (!numbers.contains(first + i)) return false;
  }
  return true;
}

// Whether the geometry has all points, if each of these files is one.
bool knows_points(const std::set<int>& geometry, const std::vector<std::string>& files) {
  std::set<int> points;
  for (std::size_t i = 0; i < files.size(); ++i) points.insert(static_cast<int>(i));
  const GeometryNumbers numbers = geometry_numbers(geometry, points, files);
  if (numbers == GeometryNumbers::record) return holds_from(geometry, 0, files.size());
  return numbers != GeometryNumbers::contradicted;
}

}  // namespace

std::string short_file_name(const std::string& path) {
  return one_line(std::filesystem::path(path).filename().string(), kMaxNameBytes);
}

std::vector<std::string> files_of_points(const acquire::Record& record, const std::set<int>& points) {
  if (points.size() < 2 || record.files.size() < points.size()) return {};
  if (*points.begin() != 0 || *points.rbegin() != static_cast<int>(points.size()) - 1) return {};
  std::vector<std::string> paths;
  for (const acquire::InputFile& file : record.files) paths.push_back(file.path);
  const std::set<std::string> different(paths.begin(), paths.end());
  if (different.size() != paths.size()) return {};
  for (PointsOfFiles& found : points_of_files(paths, points.size())) {
    const bool fits = std::all_of(record.rows.begin(), record.rows.end(), [&](const acquire::RowInfo& row) {
      return found.point_of.at(row.file) == static_cast<std::size_t>(row.point);
    });
    if (fits) return std::move(found.paths);
  }
  return {};
}

std::optional<std::vector<int>> numbers_in_names(const std::vector<std::string>& names, const std::set<int>& geometry) {
  std::vector<NameParts> parts;
  parts.reserve(names.size());
  for (const std::string& name : names) parts.push_back(texts_and_numbers(name));
  const auto differing = differing_numbers(parts);
  if (!differing) return std::nullopt;
  std::set<std::vector<int>> fitting;
  for (const std::size_t i : *differing) {
    const auto numbers = different_numbers(parts, i);
    if (numbers && (differing->size() == 1 || holds_all(geometry, *numbers))) fitting.insert(*numbers);
  }
  return fitting.size() == 1 ? std::optional(*fitting.begin()) : std::nullopt;
}

GeometryNumbers geometry_numbers(const std::set<int>& geometry, const std::set<int>& measured,
                                 const std::vector<std::string>& files) {
  const auto lacks = [&](int offset) {
    return std::any_of(measured.begin(), measured.end(), [&](int point) { return !geometry.contains(point + offset); });
  };
  const bool from_one = lacks(0) && !lacks(1) && !geometry.contains(0);
  const GeometryNumbers in_order = from_one ? GeometryNumbers::from_one : GeometryNumbers::record;
  const auto numbers = numbers_in_names(files, geometry);
  if (!numbers) return in_order;
  const auto known = std::count_if(numbers->begin(), numbers->end(), [&](int n) { return geometry.contains(n); });
  if (known == static_cast<std::ptrdiff_t>(numbers->size())) return GeometryNumbers::file_names;
  if (geometry.size() != files.size()) return GeometryNumbers::contradicted;
  const std::set<int> named(numbers->begin(), numbers->end());
  const bool other_start = (holds_from(named, 1, files.size()) && holds_from(geometry, 0, files.size())) ||
                           (holds_from(named, 0, files.size()) && holds_from(geometry, 1, files.size()));
  // The order of the files decides then, so it must be the order of the numbers.
  if (other_start && std::is_sorted(numbers->begin(), numbers->end())) return in_order;
  return known == 0 ? in_order : GeometryNumbers::contradicted;
}

NamedFiles judge_named_files(const std::vector<std::string>& paths, const std::vector<acquire::FilesOfHits>& groups,
                             const std::set<int>& geometry) {
  if (groups.empty()) return NamedFiles::points;
  if (geometry.empty()) return NamedFiles::undecided;
  if (geometry.size() == groups.size()) return NamedFiles::hits;
  std::vector<std::string> stems;
  for (const acquire::FilesOfHits& group : groups) stems.push_back(group.stem);
  if (!knows_points(geometry, paths)) return NamedFiles::hits;
  return knows_points(geometry, stems) ? NamedFiles::undecided : NamedFiles::points;
}

TwoNumbers judge_two_numbers(const std::vector<std::string>& paths,
                             std::vector<std::vector<acquire::FilesOfHits>> groupings, const std::set<int>& geometry) {
  if (groupings.empty() || geometry.size() == paths.size()) return {};
  const bool may_be_points = geometry.empty() || knows_points(geometry, paths);
  if (may_be_points) {
    // Points of a symmetric structure can agree as hits do, so only the usual order of the numbers is tried.
    std::erase_if(groupings, [&](const auto& groups) {
      return !std::all_of(groups.begin(), groups.end(),
                          [&](const auto& group) { return paths[group.files.front()].starts_with(group.stem); });
    });
  }
  if (geometry.empty()) return {.groupings = std::move(groupings)};
  std::erase_if(groupings, [&](const auto& groups) {
    std::vector<std::string> stems;
    for (const acquire::FilesOfHits& group : groups) stems.push_back(group.stem);
    return !knows_points(geometry, stems);
  });
  const auto is_equal = [&](const auto& groups) { return groups.size() == geometry.size(); };
  if (std::any_of(groupings.begin(), groupings.end(), is_equal)) std::erase_if(groupings, std::not_fn(is_equal));
  const bool certain = groupings.size() == 1 && !may_be_points;
  return {.groupings = std::move(groupings), .certain = certain};
}

bool named_as_points(const std::vector<std::string>& paths) {
  if (!acquire::files_of_hits(paths).empty() || !acquire::groupings_by_two_numbers(paths).empty()) return true;
  return numbers_in_names(paths).has_value() && acquire::files_called_hits(paths).empty();
}

PointNames::PointNames(const acquire::Record& record, const std::set<int>& points, const std::set<int>& geometry) {
  const std::vector<std::string> files = files_of_points(record, points);
  // With stated directions, several points share a place, and the geometry numbers places.
  if (!geometry.empty() && record.motions.empty())
    geometry_from_one_ = geometry_numbers(geometry, points, files) == GeometryNumbers::from_one;
  auto numbers = numbers_in_names(files, geometry);
  // If the geometry has none of the numbers, they are not numbers of points.
  if (numbers && !geometry.empty() &&
      std::none_of(numbers->begin(), numbers->end(), [&](int n) { return geometry.contains(n); }))
    numbers.reset();
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto point = static_cast<int>(i);
    of_files_[point] = {.number = numbers ? numbers->at(i) : point + (geometry_from_one_ ? 1 : 0),
                        .file = short_file_name(files[i])};
  }
}

int PointNames::number(int point) const {
  const auto named = of_files_.find(point);
  if (named != of_files_.end()) return named->second.number;
  return geometry_from_one_ ? point + 1 : point;
}

std::string PointNames::name(int point) const {
  const auto named = of_files_.find(point);
  if (named != of_files_.end()) return fmt::format("{} ({})", named->second.number, named->second.file);
  return fmt::format("{}{}", number(point), geometry_from_one_ ? " of the geometry" : "");
}

std::string PointNames::list(const std::vector<int>& points, std::size_t max) const {
  const bool of_geometry = of_files_.empty() && geometry_from_one_;
  const auto one = [&](std::size_t i) { return of_geometry ? std::to_string(number(points[i])) : name(points[i]); };
  return fmt::format("point{} {}{}", plural(points.size()), limited_list(points.size(), max, one),
                     of_geometry ? " of the geometry" : "");
}

}  // namespace percuss::pipeline
