#include "pipeline/node_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include "acquire/geometry/geometry.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "identify/shapes/scan_outliers.hpp"
#include "identify/shapes/scan_scatter.hpp"
#include "pipeline/warnings/scan_warnings.hpp"

namespace percuss::pipeline {
namespace {

constexpr std::size_t kMinPoints = 3;  // two points show a change of sign, but not where it lies between them

// |H| at the mode's peak for each point of `at`: the root of the sum of squares over the channels.
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
  std::vector<std::pair<double, int>> ascending;
  for (const int point : analysis.points()) ascending.emplace_back(positions.at_m(ascending.size()), point);
  std::sort(ascending.begin(), ascending.end());
  MeasuredPoints measured;
  std::string missing;
  for (const auto& [position_m, point] : ascending) {
    if (with_frf.contains(point)) {
      measured.point.push_back(point);
      measured.position_m.push_back(position_m);
    } else {
      missing += fmt::format("{}{:.4g} in", missing.empty() ? "" : ", ", position_m / kInch_m);
    }
  }
  if (!missing.empty()) warnings.push_back(missing_positions(missing));
  return measured;
}

// The indices of the modes that are no hoop modes.
std::vector<std::size_t> modes_of_scan(const Analysis& analysis) {
  std::vector<std::size_t> shown;
  for (std::size_t m = 0; m < analysis.modes().size(); ++m) {
    if (analysis.classifications()[m].type != identify::ModeType::hoop) shown.push_back(m);
  }
  return shown;
}

// [points of the shape][hits] the amplitudes of one mode.
std::vector<std::vector<identify::AmplitudeOfHit>> amplitudes_of(const Analysis& analysis, const identify::Mode& mode,
                                                                 const std::vector<ModeInHit>& hits,
                                                                 const MeasuredPoints& measured,
                                                                 const identify::ScanShape& shape) {
  const std::vector<int> points = analysis.frf_points();
  const auto factors = identify::channel_factors(mode, measured.point, measured.position_m);
  std::vector<std::vector<identify::AmplitudeOfHit>> out(shape.position_m.size());
  for (const ModeInHit& hit : hits) {
    const auto at = std::find(measured.point.begin(), measured.point.end(), points[hit.point]);
    if (at == measured.point.end()) continue;
    const double position_m = measured.position_m[static_cast<std::size_t>(at - measured.point.begin())];
    const auto place = std::find(shape.position_m.begin(), shape.position_m.end(), position_m);
    if (place == shape.position_m.end() || hit.residues.size() != factors.size()) continue;
    identify::AmplitudeOfHit one{.power = hit.power, .hit = hit.hit};
    double noise2 = 0;
    for (const identify::HitResidue& residue : hit.residues) {
      const Complex factor = factors[mode.residues[residue.residue].channel];
      one.value += (factor * residue.value).real();
      noise2 += std::norm(factor) * residue.std * residue.std;
    }
    one.std = std::hypot(std::sqrt(noise2), hit.relative_std * one.value);
    out[static_cast<std::size_t>(place - shape.position_m.begin())].push_back(one);
  }
  return out;
}

// The shapes along the scan, and the amplitudes of the hits.
std::vector<identify::HitsAlongScan> hits_along_scan(const Analysis& analysis, const std::vector<std::size_t>& shown,
                                                     const MeasuredPoints& measured) {
  std::vector<identify::HitsAlongScan> modes;
  const auto hits = analysis.residues_per_hit();
  for (const std::size_t m : shown) {
    const identify::Mode& mode = analysis.modes()[m];
    modes.push_back({.shape = identify::shape_along(mode, measured.point, measured.position_m), .hits = {}});
    if (m < hits.size()) modes.back().hits = amplitudes_of(analysis, mode, hits[m], measured, modes.back().shape);
  }
  return modes;
}

struct ShapeOfScan {
  identify::ScanShape shape;
  bool varies = false;  // from hit to hit
};

// The shapes with their standard deviations. If the hits scatter about their places, the scatter of all points and
// modes together gives the standard deviations, because two or three hits do not determine the scatter of one point.
// The mean of a mode that varies by as much as its amplitude is no shape: its signs are those of the hits' directions.
std::vector<ShapeOfScan> shapes_of(const std::vector<identify::HitsAlongScan>& modes) {
  constexpr double kVaries = 0.5;  // of the rms amplitude
  const std::vector<identify::ScanScatter> scatter = identify::scatter_along_scan(modes);
  std::vector<ShapeOfScan> shapes;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (scatter.empty()) {
      shapes.push_back({.shape = modes[m].shape});
    } else {
      shapes.push_back(
          {.shape = identify::with_scatter(modes[m], scatter[m]), .varies = scatter[m].of_amplitude > kVaries});
    }
  }
  return shapes;
}

void find_nodes_of(ModeAlongScan& along, bool varies, bool enough) {
  if (!enough) {
    along.no_node = identify::NoNode::few_positions;
  } else if (varies) {
    along.no_node = identify::NoNode::varies;
  } else {
    along.nodes = identify::find_nodes(along.shape);
    identify::drop_wide_nodes(along.nodes, along.shape);
    if (along.nodes.empty()) along.no_node = identify::reason_without_node(along.shape);
  }
}

void add_hit_warnings(const Analysis& analysis, const std::vector<identify::HitsAlongScan>& modes,
                      std::vector<Warning>& warnings) {
  const auto& frfs = analysis.frfs();
  const bool one_each = std::all_of(frfs.begin(), frfs.end(), [](const auto& one) { return one.frf.averages == 1; });
  if (analysis.given_frfs() == nullptr && one_each && !modes.empty()) warnings.push_back(one_hit_per_position());
  const auto outliers = identify::scan_outliers(modes);
  if (!outliers.empty()) warnings.push_back(misplaced_hits(outliers, modes.front().shape.position_m));
}

// Distances of the points from the first one by the record's geometry; nothing where it does not place every point.
std::optional<std::vector<double>> distances_m(const acquire::Record& record, const std::set<int>& points) {
  const auto geometry = acquire::geometry_of_record(record.geometry);
  if (!geometry) return std::nullopt;
  std::vector<double> out;
  const acquire::GeometryPoint* first = nullptr;
  for (const int point : points) {
    const acquire::GeometryPoint* at = acquire::find_point(*geometry, point);
    if (at == nullptr || (!geometry->tube && !at->xyz_m)) return std::nullopt;
    if (first == nullptr) first = at;
    if (geometry->tube) {
      out.push_back(std::abs(at->position_m - first->position_m));
    } else {
      const auto &a = *at->xyz_m, &b = *first->xyz_m;
      out.push_back(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return out;
}

void require_positions_match_geometry(const Analysis& analysis, const ScanPositions& positions) {
  constexpr double kMaxDifference = 0.1;  // of the scan's length: sensors and hits are placed by hand
  const auto known_m = distances_m(analysis.record(), analysis.points());
  if (!known_m) return;
  double length_m = 0, difference_m = 0;
  for (std::size_t i = 0; i < known_m->size(); ++i) {
    const double from_first_m = std::abs(positions.at_m(i) - positions.at_m(0));
    length_m = std::max(length_m, from_first_m);
    difference_m = std::max(difference_m, std::abs(known_m->at(i) - from_first_m));
  }
  if (difference_m <= kMaxDifference * length_m) return;
  throw InputError(
      fmt::format(
          "the positions and the record's geometry differ by up to {:.4g} in; the scan is {:.4g} in long by the "
          "positions, {:.4g} in by the geometry",
          difference_m / kInch_m, length_m / kInch_m, *std::max_element(known_m->begin(), known_m->end()) / kInch_m),
      analysis.record().source(), "state the positions of the points, with their unit", {"positions"});
}

// Rows that as_scan assigned to positions are no scan where every mode has the same size at all positions.
void require_different_points(const Analysis& analysis, const NodeScan& scan) {
  constexpr double kMinDifference = 0.05;  // of the largest size
  double most = 0;
  for (const ModeAlongScan& along : scan.modes) {
    assert(!along.shape.amplitude.empty());  // a mode comes from an FRF, whose point has a position
    const auto [low, high] = std::minmax_element(along.shape.amplitude.begin(), along.shape.amplitude.end());
    const double largest = std::max(std::abs(*low), std::abs(*high));
    if (largest > 0) most = std::max(most, (*high - *low) / largest);
  }
  if (scan.modes.empty() || most > kMinDifference) return;
  throw InputError(
      fmt::format("all positions have the same response within {:.1g} %: the hits are at one point", 100 * most),
      analysis.record().source(), "give a record with hits at every position", {"positions"});
}

}  // namespace

NodeScan scan_nodes(const Analysis& analysis, const ScanPositions& positions, double resolution_m,
                    bool assumed_points) {
  const std::size_t points = analysis.points().size();
  if (points != positions.count) {
    throw InputError(fmt::format("{} points for {} positions", points, positions.count), analysis.record().source(),
                     "state one position per point", {"positions"});
  }
  require_positions_match_geometry(analysis, positions);
  NodeScan scan{.positions = positions, .modes = {}, .warnings = {}};
  const MeasuredPoints measured = measured_points(analysis, positions, scan.warnings);
  const bool enough = measured.point.size() >= kMinPoints;
  if (!enough) scan.warnings.push_back(few_positions(measured.point.size()));
  const std::vector<std::size_t> shown = modes_of_scan(analysis);
  const std::vector<identify::HitsAlongScan> along_scan = hits_along_scan(analysis, shown, measured);
  const std::vector<ShapeOfScan> shapes = shapes_of(along_scan);
  add_hit_warnings(analysis, along_scan, scan.warnings);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const identify::Mode& mode = analysis.modes()[shown[i]];
    ModeAlongScan along{.mode = shown[i],
                        .shape = shapes[i].shape,
                        .peak = peaks_of(analysis, mode, measured.point),
                        .nodes = {},
                        .no_node = {},
                        .minimum_m = {}};
    find_nodes_of(along, shapes[i].varies, enough);
    along.minimum_m = identify::minimum_of_peak(measured.position_m, along.peak, resolution_m);
    scan.modes.push_back(std::move(along));
  }
  if (assumed_points) require_different_points(analysis, scan);
  return scan;
}

}  // namespace percuss::pipeline
