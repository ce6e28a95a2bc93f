#include "acquire/record/trace_faces.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace percuss::acquire {
namespace {

constexpr double kNoCorner = -1;

}  // namespace

FaceTable face_table(const std::vector<TraceFace>& faces) {
  FaceTable table;
  for (const TraceFace& face : faces) table.width = std::max(table.width, face.size());
  for (const TraceFace& face : faces) {
    table.numbers.insert(table.numbers.end(), face.begin(), face.end());
    table.numbers.insert(table.numbers.end(), table.width - face.size(), kNoCorner);
  }
  return table;
}

std::vector<TraceFace> trace_faces_of(const FaceTable& table, std::size_t points, const std::string& where) {
  std::vector<TraceFace> faces;
  for (std::size_t first = 0; first + table.width <= table.numbers.size() && table.width > 0; first += table.width) {
    TraceFace face;
    bool ended = false;
    for (std::size_t i = first; i < first + table.width; ++i) {
      const double number = table.numbers[i];
      const bool empty = std::isnan(number) || number == kNoCorner;
      if (ended && !empty) throw InputError("a corner after a missing one", where, "store -1 after the last corner");
      ended = empty;
      if (!empty) face.push_back(geometry_point(number, points, "face", where));
    }
    if (face.size() < 3) throw InputError("a face of fewer than three corners", where, "store three points or more");
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace percuss::acquire
