#pragma once
#include <array>
#include <map>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"

namespace percuss::acquire {

/// Nodes of the data sets 15 and 2411 in m and global coordinates: divided by the units' length factor and turned out
/// of the coordinate systems that set 18 defines (cartesian, cylindrical, spherical). Later ones win.
/// errors  InputError with file and line: a line that cannot be read, a node in a coordinate system that is not there.
std::map<int, std::array<double, 3>> read_uff_nodes(const std::vector<UffSet>& sets, const FileBytes& file,
                                                    double length_factor);

}  // namespace percuss::acquire
