#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// The figures for the records of record_sweeps(): FRFs by H1, H2 and Hv, modes by each effort. Errors are over all
/// runs. Times are from the HDF5 file of the first run to FRFs or to classified modes, on one thread.
struct RecordStudy {
  TaskFigures frfs, modes;
};
RecordStudy study_records(Extent extent, const TimingOptions& timing);

}  // namespace percuss::accuracy
