#pragma once
#include <array>
#include <map>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"

namespace percuss::acquire {

/// Nodes of the data sets 15 and 2411 in m and global coordinates: divided by the units' length factor and transformed
/// from the coordinate systems of set 18 (cartesian, cylindrical, spherical). A later definition of a node replaces an
/// earlier one.
/// errors  InputError with file and line: a line cannot be read, a node refers to an undefined coordinate system.
std::map<int, std::array<double, 3>> read_uff_nodes(const std::vector<UffSet>& sets, const FileBytes& file,
                                                    double length_factor);

}  // namespace percuss::acquire
