#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "acquire/record/record.hpp"

namespace percuss::acquire {

/// Faces as files store them: a row per face with its corners in order, then -1 up to the width.
struct FaceTable {
  std::size_t width = 0;
  std::vector<double> numbers{};  // [faces][width]
};

FaceTable face_table(const std::vector<TraceFace>& faces);

/// The faces in such a table; NaN may stand for -1. `points`: the number of points that exist. `where` names the table.
/// errors  InputError: fewer than three corners, a corner that is no point, a corner after a -1.
std::vector<TraceFace> trace_faces_of(const FaceTable& table, std::size_t points, const std::string& where);

}  // namespace percuss::acquire
