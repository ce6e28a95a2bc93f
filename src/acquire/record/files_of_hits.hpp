#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace percuss::acquire {

/// Files that are hits of one point by their names.
struct FilesOfHits {
  std::string stem;                // what their paths have in common: "P3" of P3_1.csv and P3_2.csv
  std::vector<std::size_t> files;  // indices, in their order
};

/// Groups files of the names NAME_1, NAME_2, …: each name ends in a number, before the extension, and in front of it
/// stands _, -, a blank, an opening parenthesis, "hit" or "h". Files of one NAME are a group. The groups have
/// the order of their first files. Empty unless all names have this form, no two files of a group have the same number,
/// and at least two groups have the same numbers, two or more.
std::vector<FilesOfHits> files_of_hits(const std::vector<std::string>& paths);

}  // namespace percuss::acquire
