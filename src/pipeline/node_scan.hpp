#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/shapes/nodes.hpp"
#include "pipeline/analysis.hpp"
#include "pipeline/scan_positions.hpp"

namespace percuss::pipeline {

/// One mode along the scan.
struct ModeAlongScan {
  std::size_t mode = 0;       // index into Analysis::modes()
  identify::ScanShape shape;  // the points that have FRFs
  std::vector<double> peak;   // |H| at the mode's peak, the root of the sum of squares over the channels, (m/s²)/N
  std::vector<identify::Node> nodes;        // ascending
  std::optional<identify::NoNode> no_node;  // why `nodes` is empty
  std::optional<double> minimum_m;          // position of the minimum of `peak`, to the given resolution
};

struct NodeScan {
  ScanPositions positions;
  std::vector<ModeAlongScan> modes;  // without hoop modes
  std::vector<Warning> warnings;     // about the scan; the analysis has its own
};

/// Nodes of the modes along a scan, from all FRFs together. `assumed_points`: as_scan assigned the rows to positions.
/// errors  InputError: as Analysis::modes(); another number of points than positions; positions that contradict the
///         record's geometry; assumed points with the same response everywhere.
NodeScan scan_nodes(const Analysis& analysis, const ScanPositions& positions, double resolution_m,
                    bool assumed_points = false);

}  // namespace percuss::pipeline
