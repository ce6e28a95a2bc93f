#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "identify/identify.hpp"
#include "identify/start/stabilisation.hpp"

namespace percuss::pipeline {

struct BandModes {
  std::vector<identify::Mode> below, within, above;  // ascending
};

/// Sorts `modes`, ascending, into modes below, within and above the band. Residues carry the points' numbers, taken
/// from `points` [points of the data set].
BandModes modes_in_band(std::vector<identify::Mode> modes, const std::vector<int>& points,
                        std::pair<double, double> band_Hz);

/// The same modes with residues that carry the indices of the points in the data set, in place of their numbers.
/// points  as for modes_in_band, ascending
std::vector<identify::Mode> with_point_indices(std::vector<identify::Mode> modes, const std::vector<int>& points);

/// The two sensors whose angles suit best for bending and hoop.
std::optional<identify::SensorPair> sensor_pair(const std::vector<acquire::SignalInfo>& accel);

/// Classifies modes by the two sensors whose angles suit best, and by the overlay of their FRFs at each mode's peak.
std::vector<identify::ModeClassification> classify_modes(const std::vector<identify::Mode>& modes,
                                                         const identify::FrfDataset& set,
                                                         const std::vector<acquire::SignalInfo>& accel,
                                                         const identify::ClassifyOptions& options);

/// The classifications of the modes `part`, taken from the `classifications` of the modes `all`. A mode does not count
/// as split if its other peak is not in `part`.
std::vector<identify::ModeClassification> classifications_of_part(
    const std::vector<identify::ModeClassification>& classifications, const std::vector<identify::Mode>& all,
    const std::vector<identify::Mode>& part);

/// The stabilisation diagram of `set` with the poles within the band.
identify::Stabilisation stabilisation_in_band(const identify::FrfDataset& set, std::pair<double, double> band_Hz);

}  // namespace percuss::pipeline
