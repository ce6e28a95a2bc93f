#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// Measures the largest deflection of a held beam (14.5, 90 and 322 Hz) by every method of deflection_of. The test has
/// three rows of 1.2 s at 10 kHz, each with a pulse of 2.5 ms after 0.1 s of rest, noise of 0.1 % of the RMS
/// acceleration, a bias of 0.3 m/s² and a drift of 0.1 m/s³. Times are from an HDF5 file to the deflections on one
/// thread. For the method modal they include the identification of the modes. Errors and coverage include only hits
/// with a significant deflection; the column "detected" is the share of these hits.
TaskFigures study_deflection(Extent extent, const TimingOptions& timing);

}  // namespace percuss::accuracy
