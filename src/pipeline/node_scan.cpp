#include "pipeline/node_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/units.hpp"

namespace percuss::pipeline {
namespace {

// |H| at the mode's peak for each point of `at`.
std::vector<double> peaks_of(const Analysis& analysis, const identify::Mode& mode, const std::vector<int>& at) {
  const std::size_t k = analysis.lines().nearest(mode.pole.freq_Hz);
  std::vector<double> peak(at.size());
  for (const acquire::PointFrf& frf : analysis.frfs()) {
    const auto place = std::find(at.begin(), at.end(), frf.point) - at.begin();
    if (static_cast<std::size_t>(place) == at.size()) continue;
    double& sum = peak[static_cast<std::size_t>(place)];
    sum = std::hypot(sum, std::abs(frf.frf.value[k]));
  }
  return peak;
}

// Points that have FRFs, and their positions.
struct MeasuredPoints {
  std::vector<int> point;
  std::vector<double> position_m;
};

MeasuredPoints measured_points(const Analysis& analysis, const ScanPositions& positions,
                               std::vector<Warning>& warnings) {
  std::set<int> with_frf;
  for (const acquire::PointFrf& frf : analysis.frfs()) with_frf.insert(frf.point);
  MeasuredPoints measured;
  std::string missing;
  std::size_t i = 0;
  for (const int point : analysis.points()) {
    const double position_m = positions.at_m(i++);
    if (with_frf.contains(point)) {
      measured.point.push_back(point);
      measured.position_m.push_back(position_m);
    } else {
      missing += fmt::format("{}{:.4g} in", missing.empty() ? "" : ", ", position_m / kInch_m);
    }
  }
  if (!missing.empty()) {
    warnings.push_back(
        {"missing_position", "no usable hit at " + missing + ": the nodes are found without these positions"});
  }
  return measured;
}

}  // namespace

acquire::Record as_scan(acquire::Record record, const ScanPositions& positions) {
  const std::size_t points = record.points().size();
  const std::size_t rows = record.rows.size();
  if (points == positions.count) return record;
  if (points != 1 || rows < positions.count || rows % positions.count != 0 || record.continuous) {
    throw InputError(fmt::format("{} point{} and {} row{} of hits for {} positions", points, points == 1 ? "" : "s",
                                 rows, rows == 1 ? "" : "s", positions.count),
                     record.source(), "state START:STEP:END with one position per point, file or row, in their order",
                     {"positions"});
  }
  const std::size_t each = rows / positions.count;
  for (std::size_t row = 0; row < rows; ++row) record.rows[row].point = static_cast<int>(row / each);
  record.notes.emplace_back(
      fmt::format("the points of the hits are not stated: each position of the scan is assumed to have {} row{}, in "
                  "order",
                  each, each == 1 ? "" : "s"));
  return record;
}

NodeScan scan_nodes(const Analysis& analysis, const ScanPositions& positions, double resolution_m) {
  const std::size_t points = analysis.points().size();
  if (points != positions.count) {
    throw InputError(fmt::format("{} points for {} positions", points, positions.count), analysis.record().source(),
                     "state one position per point", {"positions"});
  }
  NodeScan scan{.positions = positions, .modes = {}, .warnings = {}};
  const MeasuredPoints measured = measured_points(analysis, positions, scan.warnings);
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    if (analysis.classifications()[m].family == identify::ModeType::hoop) continue;
    const identify::Mode& mode = analysis.modes()[m];
    ModeAlongScan along{.mode = m,
                        .shape = identify::shape_along(mode, measured.point, measured.position_m),
                        .peak = peaks_of(analysis, mode, measured.point),
                        .nodes = {},
                        .minimum_m = {}};
    along.nodes = identify::find_nodes(along.shape);
    along.minimum_m = identify::minimum_of_peak(measured.position_m, along.peak, resolution_m);
    scan.modes.push_back(std::move(along));
  }
  return scan;
}

}  // namespace percuss::pipeline
