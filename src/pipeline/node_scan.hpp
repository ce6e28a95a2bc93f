#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/shapes/nodes.hpp"
#include "pipeline/analysis.hpp"

namespace percuss::pipeline {

/// The places of a scan of impacts, one per point in ascending order of the points' numbers.
struct ScanPositions {
  double start_m = 0, step_m = 0;
  std::size_t count = 0;
  double at_m(std::size_t i) const { return start_m + static_cast<double>(i) * step_m; }
};

/// One mode along the scan.
struct ModeAlongScan {
  std::size_t mode = 0;       // index into Analysis::modes()
  identify::ScanShape shape;  // the points that have FRFs
  std::vector<double> peak;   // |H| at the mode's peak, the root of the sum of squares over the channels, (m/s²)/N
  std::vector<identify::Node> nodes;  // ascending
  std::optional<double> rule_m;       // the minimum of `peak`, to the resolution asked for
};

struct NodeScan {
  ScanPositions positions;
  std::vector<ModeAlongScan> modes;  // those that bend, or may: hoop modes have no node on a line along the barrel
  std::vector<Warning> warnings;     // on the scan; the analysis has its own
};

/// The record as one scan: where it has one point only but as many rows as the scan has places, or twice, three times …
/// as many, rows in turn belong to one place after the other. Throws InputError unless there are as many points as
/// places.
acquire::Record as_scan(acquire::Record record, const ScanPositions& positions);

/// Nodes of the modes of a scan, from all FRFs together. Throws InputError as Analysis::modes() does, and unless there
/// are as many points as places.
NodeScan scan_nodes(const Analysis& analysis, const ScanPositions& positions, double resolution_m);

}  // namespace percuss::pipeline
