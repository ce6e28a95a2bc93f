#pragma once
#include <string>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// Writes mode shapes as a universal file, which other packages animate. It holds sets 151 and 164, and each mode as 55
/// and 2414 (complex, three translations per node). Where all positions are known, it also holds nodes (15 and 2411),
/// trace lines (82) and faces (2412, triangles and quadrilaterals) as plot_mesh gives them. A node is a point of the
/// test (node = point + 1 where points begin at 0), or the place of several points that were struck in several
/// directions. A component is along the direction that the record states, else along the normal of the structure, which
/// points out of a tube or a closed surface. The components of sensors at one point of a structure that is no tube are
/// along their angles (0° along y, 90° along z).
/// errors  InputError: the file exists (without `force`) or cannot be written, no modes.
void write_modes_uff(const std::string& path, const pipeline::Survey& survey, bool force);

/// The same for a test without geometry. The node of a single point, or of roving sensors, has a component per sensor.
/// Where there are several struck points, each point has one component.
void write_modes_uff(const std::string& path, const pipeline::Analysis& analysis, bool force);

}  // namespace percuss::report
