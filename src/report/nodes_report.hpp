#pragma once

#include "pipeline/node_scan.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// JSON: percuss/nodes/1 (docs/schema/nodes.schema.json). Text: a table of modes with each node, its standard
/// deviation, and the position of the smallest peak, in inches from the barrel's end, then the warnings. Chart: each
/// mode along the scan with its nodes.
CommandReport nodes_report(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan);

}  // namespace percuss::report
