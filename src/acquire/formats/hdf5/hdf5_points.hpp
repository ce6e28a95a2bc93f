#pragma once
#include <string>
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "acquire/record/record.hpp"

namespace percuss::acquire::hdf5 {

// The caller holds a Lock.
// errors  InputError: impossible shapes and values.

/// One whole number per row; zeros when the set is absent.
std::vector<int> numbers_per_row(const InputHdf5& file, const std::string& name, std::size_t rows);

/// Why each row was rejected while it was recorded; RowMark::none for all rows when the set is absent.
std::vector<RowMark> read_marks(const InputHdf5& file, std::size_t rows);

/// Faults of the capture; none when the set is absent.
std::vector<RecordFault> read_faults(const InputHdf5& file, std::size_t rows);

/// Coordinates [points][2 or 3]. NaN marks a point without coordinates. Empty when the set is absent.
std::vector<std::vector<double>> read_geometry(const InputHdf5& file);

/// Lines between points; `points` is the number of points. Empty when the set is absent.
std::vector<TraceLine> read_trace_lines(const InputHdf5& file, std::size_t points);

/// Faces from /trace_faces [faces, corners], with -1 after the last corner. `points` as above. Empty when the set is
/// absent.
std::vector<TraceFace> read_trace_faces(const InputHdf5& file, std::size_t points);

}  // namespace percuss::acquire::hdf5
