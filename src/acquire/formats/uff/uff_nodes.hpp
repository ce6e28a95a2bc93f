#pragma once
#include <array>
#include <map>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"

namespace percuss::acquire {

/// In m and global coordinates.
struct UffNodes {
  std::map<int, std::array<double, 3>> nodes_m;
  std::size_t left_out = 0;  // in other coordinate systems of set 2420 than the global one
};

/// Nodes of the data sets 15 and 2411 in m and global coordinates: divided by the units' length factor and transformed
/// from the coordinate systems of set 18 (cartesian, cylindrical, spherical). A later definition of a node replaces an
/// earlier one.
/// Data set 2420 defines coordinate systems too. Only one that equals the global system (cartesian, without rotation
/// and shift) is understood: nodes in the others are left out.
/// errors  InputError with file and line: a line cannot be read, a node refers to a coordinate system that no set
///         defines.
UffNodes read_uff_nodes(const std::vector<UffSet>& sets, const FileBytes& file, double length_factor);

}  // namespace percuss::acquire
