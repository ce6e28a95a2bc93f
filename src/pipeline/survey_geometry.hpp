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

/// errors  InputError at `where`: the geometry lacks a point that was measured. If it may number its points from
/// 1 and the record from 0, the message states the missing point in these numbers, too.
void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where);

/// The points of a stated geometry that were not measured: a survey in parts, or a missing file that shifts all others.
std::vector<Warning> missing_points(const acquire::Geometry& geometry, const std::set<int>& measured,
                                    std::size_t files);

/// Points around a tube whose angles hardly differ: radians read as degrees, or a plate read as a tube.
std::vector<Warning> narrow_arc(const acquire::Geometry& geometry);

}  // namespace percuss::pipeline
