#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "acquire/record/files_of_hits.hpp"
#include "acquire/record/record.hpp"

namespace percuss::pipeline {

/// The name of a file without its folder, on one line, cut after kMaxNameBytes.
std::string short_file_name(const std::string& path);

/// [points] the path of each point's file, if percuss numbered the points by the files: 0, 1, … in their order. If each
/// hit is a file (acquire::files_of_hits, acquire::groupings_by_two_numbers), the path without the number of the hit:
/// "P3" for P3_1.csv and P3_2.csv. Empty for other records, and if several files have one path.
std::vector<std::string> files_of_points(const acquire::Record& record, const std::set<int>& points);

/// The numbers in names that differ in whole numbers only: 1, 2, 10 for P1.csv, P2.csv, P10.csv. If several numbers of
/// the names differ, the one whose values are all in `geometry`, the numbers of a stated geometry: 1 and 3 for
/// M7_P1.csv and M9_P3.csv, if it has the points 1 to 3. Nothing for other names, for numbers of more than nine digits,
/// for equal numbers, and where several numbers of the names fit the geometry.
std::optional<std::vector<int>> numbers_in_names(const std::vector<std::string>& names,
                                                 const std::set<int>& geometry = {});

/// How the numbers of a stated geometry relate to the points of a test.
enum class GeometryNumbers {
  record,       // they are the record's numbers
  from_one,     // they are the record's numbers plus one
  file_names,   // they are the numbers in the names of the points' files
  contradicted  // the geometry lacks some of the numbers in the names of the files
};

/// Matches the numbers of a geometry to `measured`, the record's numbers of the points. `files`: from
/// files_of_points(). If the names of the files have numbers, these numbers decide. There are two exceptions, both only
/// if there are as many files as points in the geometry. The order of the files decides if the geometry has none of the
/// numbers, which are then something else, such as times. It also decides if the files count from 1 and the geometry
/// from 0, or the reverse.
GeometryNumbers geometry_numbers(const std::set<int>& geometry, const std::set<int>& measured,
                                 const std::vector<std::string>& files);

/// What the files of a survey are if their names form groups of acquire::files_of_hits(): each file a point, or each
/// file a hit.
enum class NamedFiles { points, hits, undecided };

/// `groups`: files_of_hits(paths). `geometry`: the numbers of the stated geometry, empty without one. The files are
/// hits if the geometry has as many points as there are groups, or if it lacks points that single files would be. They
/// are points if there are no groups, or if the geometry lacks points that the groups would be but not points that
/// single files would be. Undecided otherwise.
NamedFiles judge_named_files(const std::vector<std::string>& paths, const std::vector<acquire::FilesOfHits>& groups,
                             const std::set<int>& geometry);

/// The groupings of a survey's files whose names hold two numbers, without a word that marks the number of the hit
/// (acquire::groupings_by_two_numbers).
struct TwoNumbers {
  std::vector<std::vector<acquire::FilesOfHits>> groupings;  // that the geometry allows, the likeliest first
  bool certain = false;                                      // the first is right: the geometry allows nothing else
};

/// `groupings`: groupings_by_two_numbers(paths). `geometry`: the numbers of the stated geometry, empty without one. A
/// geometry allows a grouping if it has all points of the grouping. A geometry with as many points as a grouping allows
/// no other groupings; one with as many points as files allows none. Where each file may be a point, only the grouping
/// is left in which the number of the point stands first.
TwoNumbers judge_two_numbers(const std::vector<std::string>& paths,
                             std::vector<std::vector<acquire::FilesOfHits>> groupings, const std::set<int>& geometry);

/// Whether the files are points by their names: each differs from the others in a number, as P1, P2, … do, or they are
/// hits of several points. Not for names that call the files hits of one point (acquire::files_called_hits).
bool named_as_points(const std::vector<std::string>& paths);

/// The names of a test's points in tables, messages and pages. A point has the number in its file's name, else the
/// number in the stated geometry, else the number in the record. Documents use the record's numbers.
class PointNames {
 public:
  /// Every point has the record's number.
  PointNames() = default;
  /// `points`: the measured points. `geometry`: the numbers in the stated geometry; empty without one.
  PointNames(const acquire::Record& record, const std::set<int>& points, const std::set<int>& geometry = {});

  /// The number that people see.
  int number(int point) const;
  /// "3 (P3.csv)"; "3 of the geometry" where only its numbers differ from the record's; else "3". For use after
  /// "point".
  std::string name(int point) const;
  /// "point 3 (P3.csv)", "points 3, 4 of the geometry", "points 3, 4 and 7 more": the first `max` of them.
  std::string list(const std::vector<int>& points, std::size_t max) const;

 private:
  struct Name {
    int number = 0;
    std::string file;  // its name on one line
  };
  std::map<int, Name> of_files_;
  bool geometry_from_one_ = false;
};

}  // namespace percuss::pipeline
