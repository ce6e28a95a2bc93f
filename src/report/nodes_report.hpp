#pragma once
#include <string>

#include "pipeline/node_scan.hpp"

namespace percuss {

/// The document percuss/nodes/1 (docs/schema/nodes.schema.json), indented, with a line end.
std::string nodes_json(const Analysis& analysis, const NodeScan& scan);

/// The nodes as a person reads them: a table of modes with node ± and the rule's reading in inches from the barrel's
/// end, then warnings in words.
std::string nodes_text(const Analysis& analysis, const NodeScan& scan, std::size_t width);

}  // namespace percuss
