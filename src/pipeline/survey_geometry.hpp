#pragma once
#include <cstddef>
#include <set>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Matches the point numbers of a stated geometry to the record's: a geometry that counts from 1 where the record
/// counts from 0 is renumbered, with its lines and faces. The warnings state this, an assumed unit, and the geometry's
/// number of each driving point that the user stated (`driving`: numbers of the record).
std::vector<Warning> match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured,
                                         const std::vector<std::size_t>& driving = {});

}  // namespace percuss::pipeline
