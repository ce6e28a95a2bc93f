#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// What was found on the records of record_sweeps(): FRFs by H1, H2 and Hv, modes by each effort. The errors are those
/// of all runs; the times those of the first run read from an HDF5 file, to FRFs or to classified modes, on one thread.
struct RecordStudy {
  Family frfs, modes;
};
RecordStudy study_records(Extent extent, const TimingOptions& turns);

}  // namespace percuss::accuracy
