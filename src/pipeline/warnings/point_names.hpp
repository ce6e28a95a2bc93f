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

/// The paths of the files where percuss numbered the points: each file is one point, 0, 1, … in the order of the
/// files. Where the hits of each point are files of their own (acquire::files_of_hits), these are the paths without the
/// numbers of the hits: "P3" for P3_1.csv and P3_2.csv. Empty for other records, and where files have no names of their
/// own.
std::vector<std::string> files_of_points(const acquire::Record& record, const std::set<int>& points);

/// The numbers in names that differ in one whole number only: 1, 2, 10 for P1.csv, P2.csv, P10.csv. Nothing for other
/// names, and for numbers of more than nine digits.
std::optional<std::vector<int>> numbers_in_names(const std::vector<std::string>& names);

/// How the numbers of a stated geometry are those of a test's points.
enum class GeometryNumbers {
  record,       // they are the record's
  from_one,     // they are above the record's by one
  file_names,   // they are the numbers in the names of the points' files
  contradicted  // the numbers in the names of the files are not all in the geometry
};

/// Matches the numbers of a geometry to `measured`, the record's numbers of the points. `files` are files_of_points().
/// The numbers in the names of the files decide, where they have such numbers. They count as other numbers (of a day's
/// recordings, or times) where none of them is in the geometry, which has as many points as there are files. The files
/// and the geometry may also count the same points from 0 and from 1. The order of the files decides in both cases.
GeometryNumbers geometry_numbers(const std::set<int>& geometry, const std::set<int>& measured,
                                 const std::vector<std::string>& files);

/// What the files of a survey are if their names group them, as acquire::files_of_hits() does.
enum class NamedFiles { points, hits, undecided };

/// `groups` are files_of_hits(paths). The files are the hits of as many points as there are groups if the geometry has
/// so many points, or if it lacks points that the files would be. Without a geometry (empty), and where it knows both,
/// the names decide nothing. `geometry`: the numbers in the stated geometry.
NamedFiles judge_named_files(const std::vector<std::string>& paths, const std::vector<acquire::FilesOfHits>& groups,
                             const std::set<int>& geometry);

/// The names of a test's points in texts for people. A point has the number in its file's name. Else it has the number
/// in the stated geometry, else the one in the record, which documents use. All messages, tables and pages take a
/// point's name from here.
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
