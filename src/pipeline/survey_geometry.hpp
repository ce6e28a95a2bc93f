#pragma once
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "acquire/geometry/geometry.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// How match_point_numbers() renumbered a stated geometry.
struct MatchedPoints {
  GeometryNumbers numbers = GeometryNumbers::record;
  std::map<int, int> stated{};  // the number in the geometry's file, by the number in the record
  std::vector<Warning> warnings{};
};

/// Gives the points, lines and faces of a stated geometry the record's numbers, see geometry_numbers(). `files`: from
/// files_of_points(). If the names of the files decide, points that were not measured have numbers above all measured
/// points. If the names contradict the geometry, its numbers stay. The warnings state the assumptions, also about the
/// unit.
MatchedPoints match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured,
                                  const std::vector<std::string>& files = {});

/// errors  InputError at `where`: the matched geometry lacks a measured point. The message states the number that the
/// point has in the geometry: the number in the name of its file; or one more than the record's number, if the geometry
/// may count from 1 and the record from 0.
void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where,
                    const MatchedPoints& matched = {}, const std::vector<std::string>& files = {});

/// missing_points: the points of a matched geometry that were not measured. Either only a part of the structure was
/// surveyed, or a file is missing. Without numbers in the names, a missing file shifts the points of all later files:
/// the severity is then `warn`. `files`: number of files.
std::vector<Warning> missing_points(const acquire::Geometry& geometry, const std::set<int>& measured,
                                    const MatchedPoints& matched, std::size_t files);

/// Points around a tube whose angles hardly differ: radians read as degrees, or a plate read as a tube.
std::vector<Warning> narrow_arc(const acquire::Geometry& geometry);

}  // namespace percuss::pipeline
