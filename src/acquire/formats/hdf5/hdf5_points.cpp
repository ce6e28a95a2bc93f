#include "acquire/formats/hdf5/hdf5_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "acquire/formats/hdf5/hdf5_layout.hpp"
#include "acquire/record/trace_faces.hpp"
#include "core/error.hpp"
#include "core/io/counted_words.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kMaxPoints = 1'000'000, kMaxLines = 10'000'000, kMaxFaults = 1'000'000;
constexpr std::size_t kMaxCorners = 1000;  // of a face

}  // namespace

std::vector<int> numbers_per_row(const InputHdf5& file, const std::string& name, std::size_t rows) {
  std::vector<int> out(rows, 0);
  if (!file.has(name)) return out;
  const InputDataSet set(file, name);
  if (set.shape().size() > 1 || set.elements() != rows) {
    throw InputError("shape " + shape_text(set.shape()) + " for " + std::to_string(rows) + " hit" + plural(rows),
                     file.where(name), "store one whole number per hit");
  }
  const std::vector<double> values = set.read_all();
  for (std::size_t row = 0; row < rows; ++row) {
    if (std::rint(values[row]) != values[row] || std::abs(values[row]) > std::numeric_limits<int>::max()) {
      throw InputError("entry " + std::to_string(row) + " is not a whole number", file.where(name),
                       "store one whole number per hit");
    }
    out[row] = static_cast<int>(values[row]);
  }
  return out;
}

std::vector<RowMark> read_marks(const InputHdf5& file, std::size_t rows) {
  std::vector<RowMark> marks;
  for (const int number : numbers_per_row(file, "rejected", rows)) {
    const auto mark = row_mark(number);
    if (!mark) {
      throw InputError(
          std::to_string(number) + " is not the number of a reason", file.where("rejected"),
          "store 0 for a hit that was not rejected, or one of the reasons 1 to 15 in docs/reference/formats.md");
    }
    marks.push_back(*mark);
  }
  return marks;
}

std::vector<RecordFault> read_faults(const InputHdf5& file, std::size_t rows) {
  if (!file.has("faults")) return {};
  const InputDataSet set(file, "faults");
  if (set.shape().size() != 2 || set.shape()[1] != 4 || set.shape()[0] > kMaxFaults) {
    throw InputError("shape " + shape_text(set.shape()), file.where("faults"), "store [faults, 4]");
  }
  const std::vector<double> values = set.read_all();
  std::vector<RecordFault> faults;
  for (std::size_t i = 0; i + 4 <= values.size(); i += 4) {
    const auto fault = record_fault(std::span(values).subspan(i).first<4>(), rows);
    if (!fault) {
      throw InputError("entry " + std::to_string(i / 4) + " is not a fault", file.where("faults"),
                       "store fault, row, time and value");
    }
    faults.push_back(*fault);
  }
  return faults;
}

std::vector<std::vector<double>> read_geometry(const InputHdf5& file) {
  if (!file.has("geometry")) return {};
  const InputDataSet set(file, "geometry");
  const auto& shape = set.shape();
  if (shape.size() != 2 || (shape[1] != 2 && shape[1] != 3) || shape[0] > kMaxPoints) {
    throw InputError("shape " + shape_text(shape), file.where("geometry"), "store [points, 2 or 3]");
  }
  const std::vector<double> values = set.read_all();
  if (std::any_of(values.begin(), values.end(), [](double value) { return std::isinf(value); })) {
    throw InputError("an infinite coordinate", file.where("geometry"), "store every coordinate, or NaN");
  }
  std::vector<std::vector<double>> points;
  for (auto at = values.begin(); at != values.end(); at += static_cast<std::ptrdiff_t>(shape[1])) {
    points.emplace_back(at, at + static_cast<std::ptrdiff_t>(shape[1]));
  }
  return points;
}

std::vector<TraceLine> read_trace_lines(const InputHdf5& file, std::size_t points) {
  if (!file.has("trace_lines")) return {};
  const InputDataSet set(file, "trace_lines");
  if (set.shape().size() != 2 || set.shape()[1] != 2 || set.shape()[0] > kMaxLines) {
    throw InputError("shape " + shape_text(set.shape()), file.where("trace_lines"), "store [lines, 2]");
  }
  return trace_lines_of(set.read_all(), points, file.where("trace_lines"));
}

std::vector<TraceFace> read_trace_faces(const InputHdf5& file, std::size_t points) {
  if (!file.has("trace_faces")) return {};
  const InputDataSet set(file, "trace_faces");
  const auto& shape = set.shape();
  if (shape.size() != 2 || shape[1] < 3 || shape[1] > kMaxCorners || shape[0] > kMaxLines)
    throw InputError("shape " + shape_text(shape), file.where("trace_faces"), "store [faces, 3 corners or more]");
  return trace_faces_of({.width = shape[1], .numbers = set.read_all()}, points, file.where("trace_faces"));
}

}  // namespace percuss::acquire::hdf5
