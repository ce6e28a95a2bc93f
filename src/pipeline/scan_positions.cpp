#include "pipeline/scan_positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "acquire/geometry/geometry.hpp"
#include "acquire/hits/time_selection.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

// Along the axis in which the places differ most, provided that they hardly differ in the others.
std::optional<std::vector<double>> along_an_axis(const std::vector<std::array<double, 3>>& xyz_m) {
  constexpr double kMaxSide = 0.1;  // of the length
  std::array<double, 3> span_m{};
  for (std::size_t axis = 0; axis < span_m.size(); ++axis) {
    const auto [low, high] = std::minmax_element(xyz_m.begin(), xyz_m.end(),
                                                 [&](const auto& a, const auto& b) { return a.at(axis) < b.at(axis); });
    span_m.at(axis) = high->at(axis) - low->at(axis);
  }
  const auto longest = static_cast<std::size_t>(std::max_element(span_m.begin(), span_m.end()) - span_m.begin());
  std::vector<double> out;
  out.reserve(xyz_m.size());
  for (std::size_t axis = 0; axis < span_m.size(); ++axis) {
    if (axis != longest && span_m.at(axis) > kMaxSide * span_m.at(longest)) return std::nullopt;
  }
  for (const auto& at : xyz_m) out.push_back(at.at(longest));
  return out;
}

InputError two_points_at(double position_m, const std::string& where) {
  return InputError(fmt::format("two points of the scan lie at {:.6g} in", position_m / kInch_m), where,
                    "state a position of its own for each point", {"positions"});
}

// The first position that is stated again.
std::size_t repeated_place(const ScanPositions& positions) {
  std::set<std::size_t> known;
  const auto again = std::find_if(positions.places.begin(), positions.places.end(),
                                  [&](std::size_t place) { return !known.insert(place).second; });
  assert(again != positions.places.end());
  return *again;
}

// The points of one position become one. Their numbers are those of the positions.
acquire::Record with_points_merged(acquire::Record record, const ScanPositions& positions) {
  std::map<int, int> merged;
  for (const int point : record.points()) merged.emplace(point, static_cast<int>(positions.place(merged.size())));
  for (acquire::RowInfo& row : record.rows) row.point = merged.at(row.point);
  for (acquire::DrivingPlace& at : record.driving) {
    if (const auto known = merged.find(at.point); known != merged.end()) at.point = known->second;
  }
  for (acquire::PointMotion& at : record.motions) {
    if (const auto known = merged.find(at.point); known != merged.end()) at.point = known->second;
  }
  acquire::sort_motions(record.motions);
  return record;
}

// A range of samples of row 0.
struct CutRow {
  std::size_t first = 0, samples = 0;
};

// The reader of parts of row 0 as rows: samples in memory are viewed, not copied.
template <class... Place>
acquire::SampleReader<std::size_t, Place...> with_cut_rows(const acquire::SampleReader<std::size_t, Place...>& all,
                                                           const std::vector<CutRow>& cut) {
  using Reader = acquire::SampleReader<std::size_t, Place...>;
  typename Reader::View view;
  if (all.view()) {
    view = [cut, seen = all.view()](std::size_t row, Place... place) {
      return seen(0, place...).subspan(cut.at(row).first, cut.at(row).samples);
    };
  }
  return Reader([cut, all](std::size_t row, Place... place, std::size_t first,
                           std::span<double> samples) { all(0, place..., cut.at(row).first + first, samples); },
                std::move(view));
}

// Whether each row has one hit, the one of the same index among `hits` of the uncut row.
bool rows_hold(const acquire::Record& record, acquire::HitOptions options, const std::vector<acquire::Hit>& hits,
               const std::vector<CutRow>& cut) {
  options.from_s = 0;
  options.to_s.reset();
  const std::vector<acquire::Hit> found = acquire::find_hits(record, options);
  if (found.size() != hits.size()) return false;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    if (found[h].row != h || found[h].peak + cut[h].first != hits[h].peak) return false;
  }
  return true;
}

}  // namespace

ScanPositions listed_positions(std::vector<double> position_m, const std::string& where) {
  std::vector<double> ascending = position_m;
  std::sort(ascending.begin(), ascending.end());
  const auto twice = std::adjacent_find(ascending.begin(), ascending.end());
  if (twice != ascending.end()) throw two_points_at(*twice, where);
  return {.start_m = ascending.front(), .step_m = 0, .count = ascending.size(), .listed_m = std::move(position_m)};
}

ScanPositions repeated_positions(const std::vector<double>& position_m) {
  std::vector<double> distinct_m;
  std::vector<std::size_t> places;
  for (const double at_m : position_m) {
    const auto known = std::find(distinct_m.begin(), distinct_m.end(), at_m);
    places.push_back(static_cast<std::size_t>(known - distinct_m.begin()));
    if (known == distinct_m.end()) distinct_m.push_back(at_m);
  }
  ScanPositions positions = listed_positions(std::move(distinct_m), "");
  if (places.size() > positions.count) positions.places = std::move(places);
  return positions;
}

ScanPositions positions_of_geometry(const std::vector<std::vector<double>>& geometry, const std::set<int>& points,
                                    const std::string& where) {
  const auto refuse = [&](const std::string& problem) {
    return InputError(problem, where, "state the positions of the hits, such as 3:0.25:9in or 3,3.5,5in",
                      {"positions"});
  };
  const auto known = acquire::geometry_of_record(geometry);
  if (!known || points.empty()) throw refuse("the record does not say where its points lie");
  std::vector<double> position_m;
  std::vector<std::array<double, 3>> xyz_m;
  for (const int point : points) {
    const acquire::GeometryPoint* at = acquire::find_point(*known, point);
    if (at == nullptr) throw refuse(fmt::format("the record's geometry lacks point {}", point));
    position_m.push_back(at->position_m);
    if (at->xyz_m) xyz_m.push_back(*at->xyz_m);
  }
  if (xyz_m.size() == points.size()) {
    const auto along_m = along_an_axis(xyz_m);
    if (!along_m && !known->tube) throw refuse("the points of the record's geometry do not lie on a line");
    if (along_m) position_m = *along_m;
  }
  return listed_positions(std::move(position_m), where);
}

acquire::Record with_row_per_hit(acquire::Record record, const acquire::HitOptions& options) {
  if (record.rows.size() != 1 || !record.has_force || !record.faults.empty()) return record;
  const std::vector<acquire::Hit> hits = acquire::find_hits(record, options);
  if (hits.size() < 2) return record;
  std::vector<CutRow> cut;
  for (std::size_t h = 0; h < hits.size(); ++h) {
    const std::size_t first =
        h > 0 ? (hits[h - 1].peak + hits[h].peak) / 2 : acquire::select_time_range(record, 0, options).first;
    const std::size_t begin = std::min(first, hits[h].first);
    cut.push_back({.first = begin, .samples = hits[h].first + hits[h].samples - begin});
  }
  acquire::Record out = record;
  out.continuous = true;
  out.contiguous.clear();  // it states the place of the whole row
  out.rows.assign(hits.size(), record.rows.front());
  for (std::size_t h = 0; h < hits.size(); ++h) out.rows[h].samples = cut[h].samples;
  out.read_force_N = with_cut_rows(record.read_force_N, cut);
  out.read_accel_mps2 = with_cut_rows(record.read_accel_mps2, cut);
  if (!rows_hold(out, options, hits, cut)) return record;
  out.notes.push_back(information(
      fmt::format("the {} hits of the record have the positions of the scan, in their order", hits.size())));
  return out;
}

acquire::Record as_scan(acquire::Record record, const ScanPositions& positions, bool points_are_files) {
  const std::size_t points = record.points().size(), rows = record.rows.size(), stated = positions.stated();
  if (points == stated && (positions.places.empty() || points_are_files))
    return positions.places.empty() ? std::move(record) : with_points_merged(std::move(record), positions);
  if (points == stated) throw two_points_at(positions.at_m(repeated_place(positions)), record.source());
  if (points != 1 || rows < stated || rows % stated != 0) {
    throw InputError(fmt::format("{} point{} and {} row{} of hits for {} positions", points, points == 1 ? "" : "s",
                                 rows, rows == 1 ? "" : "s", stated),
                     record.source(),
                     "state one position per point, file or row, in their order; repeat the position of further hits, "
                     "as in 3,3,3.5,3.5in",
                     {"positions"});
  }
  const std::size_t each = rows / stated;
  for (std::size_t row = 0; row < rows; ++row) record.rows[row].point = static_cast<int>(positions.place(row / each));
  if (positions.places.empty()) {
    record.notes.emplace_back(
        fmt::format("the points of the hits are not stated: each position of the scan is assumed to have {} row{}, in "
                    "order",
                    each, each == 1 ? "" : "s"));
  }
  return record;
}

}  // namespace percuss::pipeline
