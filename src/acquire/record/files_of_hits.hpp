#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::acquire {

/// Files whose names mark them as hits of one point.
struct FilesOfHits {
  std::string stem;                // what their paths have in common: "P3" of P3_1.csv and P3_2.csv
  std::vector<std::size_t> files;  // indices, in their order
};

/// Groups files with names such as NAME_1, NAME_2, …: each name ends in a number before its extension, and before this
/// number stands _, -, a blank, an opening parenthesis, "hit" or "h". Files of one NAME are a group. The groups have
/// the order of their first files. Empty unless all names have this form, no two files of a group have the same number,
/// and at least two groups of two files or more have the same set of numbers.
std::vector<FilesOfHits> files_of_hits(const std::vector<std::string>& paths);

/// Groups files whose paths are equal but for two numbers, whatever the words are: Punkt01_Schlag1, P1-S1, P1/blow 1.
/// One number counts the points, the other the hits of each point. Returns a grouping for each possible reading, the
/// one in which the point's number stands first before the other. A group's stem ends with the point's number:
/// "Punkt01". Numbers have at most six digits. A reading is possible if there are two or more hit numbers, and if at
/// least two points, and at least half of the points, have all of them. Empty for other names. The numbers may count
/// something else, such as rows and columns: the names do not show it.
std::vector<std::vector<FilesOfHits>> groupings_by_two_numbers(const std::vector<std::string>& paths);

/// Groups files whose names call them hits: each name ends in "hit", "impact", "blow", "strike" or "tap" and a number
/// before its extension (hit1, A_hit 2, blow-3), in any letter case. Files of one folder, word and name before it are a
/// group, with what their paths have in common before the word as its stem: "A/" for A/hit1.csv and A/hit2.csv. Leaves
/// out other files, groups in which a number occurs twice, and groups of a single file. The groups have the order of
/// their first files.
std::vector<FilesOfHits> files_called_hits(const std::vector<std::string>& paths);

}  // namespace percuss::acquire
