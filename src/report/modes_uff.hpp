#pragma once
#include <string>

#include "pipeline/survey.hpp"

namespace percuss::report {

/// Mode shapes as a universal file that other packages animate: sets 151, 164, nodes as 15 and 2411 and, on a tube,
/// trace lines (82) where the places are known, and every mode as 55 and as 2414 (complex, three translations a node).
/// A node is a point of the test (node = point + 1 where points begin at 0). A component is along the outward normal of
/// a tube whose axis is x, else along z; sensors at one point stand at their angles (0° along y, 90° along z).
/// errors  InputError: the file exists (without `force`) or cannot be written, no modes.
void write_modes_uff(const std::string& path, const pipeline::Survey& survey, bool force);

/// The same for a test without geometry: with one point the sensors' components, else those of the points.
void write_modes_uff(const std::string& path, const pipeline::Analysis& analysis, bool force);

}  // namespace percuss::report
