#pragma once

#include "pipeline/node_scan.hpp"
#include "report/html/command_report.hpp"

namespace percuss::report {

/// percuss/nodes/1 (docs/schema/nodes.schema.json); a table of modes with node ± and the rule's reading in inches from
/// the barrel's end, then warnings in words; every mode along the scan with its nodes.
CommandReport nodes_report(const pipeline::Analysis& analysis, const pipeline::NodeScan& scan);

}  // namespace percuss::report
