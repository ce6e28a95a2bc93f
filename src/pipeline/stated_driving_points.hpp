#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "identify/shapes/mode_shapes.hpp"
#include "pipeline/warnings/point_names.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// A driving point as a user states it: by a number that the user sees, or by the name of the point's file.
struct StatedDrivingPoint {
  std::string file{};  // path, name, or name without extension; empty: `point` states the number
  int point = 0;
  std::size_t channel = 0;
};

/// What a user's number of a point can mean.
struct PointNumbering {
  std::set<int> points;              // numbers in the record and in the results
  std::vector<std::string> files{};  // of the points 0, 1, …; empty where the files state the numbers of their points
  bool geometry_from_one = false;    // the geometry's numbers are above the record's by one
  std::set<int> geometry{};          // the numbers in a stated geometry; they tell which numbers in names are points
};

struct DrivingPoints {
  std::vector<identify::DrivingPoint> points;  // in numbers of the record
  std::vector<Warning> warnings;               // driving_point_numbers: a number has several meanings
};

/// Finds the points that the user means. All stated numbers have the same meaning: the first one in which all of them
/// exist. If each file is a point, the order is: numbers in the files' names, numbers of a geometry that counts from 1,
/// numbers of the record. Otherwise it is: numbers of the record, numbers of such a geometry.
/// errors  InputError: a number or a file of no point.
DrivingPoints driving_points_of(const std::vector<StatedDrivingPoint>& stated, const PointNumbering& numbering,
                                const std::string& source);

}  // namespace percuss::pipeline
