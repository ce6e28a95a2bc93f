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
  std::map<int, int> stated{};  // number in the geometry's file, by the number in the record
  std::vector<Warning> warnings{};
};

/// Gives the points of a stated geometry the record's numbers, with its lines and faces: see geometry_numbers().
/// `files` are files_of_points(). A point that was not measured has a number above all measured points if the names of
/// the files decided. Numbers that the names contradict stay. The warnings state what was assumed, also about the unit.
MatchedPoints match_point_numbers(acquire::Geometry& geometry, const std::set<int>& measured,
                                  const std::vector<std::string>& files = {});

/// errors  InputError at `where`: the matched geometry lacks a point that was measured. The message states the missing
/// point in the numbers of the geometry: by the name of its file, and if the geometry may number its points from 1 and
/// the record from 0.
void require_points(const acquire::Geometry& geometry, const std::set<int>& measured, const std::string& where,
                    const MatchedPoints& matched = {}, const std::vector<std::string>& files = {});

/// The points of a matched geometry that were not measured: a survey in parts, or a missing file. Without numbers in
/// the names, a missing file shifts all others. `files`: their number.
std::vector<Warning> missing_points(const acquire::Geometry& geometry, const std::set<int>& measured,
                                    const MatchedPoints& matched, std::size_t files);

/// Points around a tube whose angles hardly differ: radians read as degrees, or a plate read as a tube.
std::vector<Warning> narrow_arc(const acquire::Geometry& geometry);

}  // namespace percuss::pipeline
