#pragma once
#include <cstddef>
#include <set>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// Whether the geometry counts its points from 1 where the record counts from 0: all measured points are present only
/// after one is subtracted.
bool counts_from_one(const acquire::Geometry& geometry, const std::set<int>& measured);

/// Matches the point numbers of a stated geometry to the record's: a geometry that counts_from_one() is renumbered,
/// with its lines and faces. The warnings state this, and an assumed unit.
std::vector<Warning> match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured);

/// errors  InputError at `where`: the geometry lacks a point that was measured. If it may number its points from
/// 1 and the record from 0, the message states the missing point in these numbers, too.
void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where);

/// The points of a stated geometry that were not measured: a survey in parts, or a missing file that shifts all others.
std::vector<Warning> missing_points(const acquire::Geometry& geometry, const std::set<int>& measured,
                                    std::size_t files);

/// Points around a tube whose angles hardly differ: radians read as degrees, or a plate read as a tube.
std::vector<Warning> narrow_arc(const acquire::Geometry& geometry);

}  // namespace percuss::pipeline
