#pragma once
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "acquire/formats/uff/uff_file.hpp"

namespace percuss::acquire {

/// The unit vectors of a node's directions 1, 2 and 3.
using UffAxes = std::array<std::array<double, 3>, 3>;

/// In m and global coordinates.
struct UffNodes {
  std::map<int, std::array<double, 3>> nodes_m;
  /// Of the nodes whose displacements are in another system than the global one; nothing where it is not known.
  std::map<int, std::optional<UffAxes>> axes;
  std::size_t left_out = 0;  // in other coordinate systems of set 2420 than the global one
};

/// Nodes of the data sets 15 and 2411 in m and global coordinates: divided by the units' length factor and transformed
/// from the coordinate systems of set 18 (cartesian, cylindrical, spherical). A later definition of a node replaces an
/// earlier one. The displacement coordinate system of a node gives its axes.
/// Data set 2420 defines coordinate systems too. Only one that equals the global system (cartesian, without rotation
/// and shift) is understood: nodes in the others are left out.
/// errors  InputError with file and line: a line cannot be read, a node refers to a coordinate system that no set
///         defines.
UffNodes read_uff_nodes(const std::vector<UffSet>& sets, const FileBytes& file, double length_factor);

}  // namespace percuss::acquire
