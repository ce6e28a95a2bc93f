#pragma once
#include <map>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "acquire/geometry/structure_mesh.hpp"

namespace percuss::report {

/// Rings around a tube, lines along it, and a face between four neighbours. `index` gives the numbers of the drawn
/// points and their indices. Neighbours on a ring are joined unless they are more than 126° apart. Two points alone on
/// a ring are always joined.
acquire::StructureMesh tube_mesh(const acquire::Geometry& geometry, const std::map<int, std::size_t>& index);

}  // namespace percuss::report
