#pragma once
#include "figures.hpp"
#include "interleaved_timing.hpp"
#include "record_cases.hpp"

namespace percuss::accuracy {

/// The largest deflection of a held beam (14.5, 90 and 322 Hz) that is struck for 2.5 ms, by every method of
/// deflection_of: three hits of 1.2 s at 10 kHz, 0.1 s of rest before each, noise of 0.1 % of the RMS acceleration, a
/// bias of 0.3 m/s² and a drift of 0.1 m/s³. From an HDF5 file to deflections, modes included where the method needs
/// them, on one thread. Hits whose deflection is not told (nothing stands out of the noise) count in a column alone.
Family study_deflection(Extent extent, const TimingOptions& turns);

}  // namespace percuss::accuracy
