#pragma once
#include <string>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// Writes mode shapes as a universal file, which other packages animate: sets 151, 164, nodes as 15 and 2411 and, on a
/// tube, trace lines (82) where positions are known, and each mode as 55 and 2414 (complex, three translations per
/// node). A node is a point of the test (node = point + 1 where points begin at 0). A component is along the outward
/// normal of a tube whose axis is x, else along z; sensors at one point stand at their angles (0° along y, 90° along
/// z). errors  InputError: the file exists (without `force`) or cannot be written, no modes.
void write_modes_uff(const std::string& path, const pipeline::Survey& survey, bool force);

/// The same for a test without geometry: with one point, the components of the sensors; else those of the points.
void write_modes_uff(const std::string& path, const pipeline::Analysis& analysis, bool force);

}  // namespace percuss::report
