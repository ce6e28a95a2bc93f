#pragma once
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "identify/classify/classify.hpp"
#include "identify/identify.hpp"
#include "identify/start/stabilisation.hpp"

namespace percuss::pipeline {

/// A mode fitted to the FRFs of one hit.
struct HitMode {
  std::size_t hit = 0;
  std::size_t mode = 0;
  identify::Pole pole;
  double freq_std_Hz = 0;
  double damping_std = 0;
};

struct BandModes {
  std::vector<identify::Mode> below, within;  // ascending
};

/// Sorts `modes`, ascending, by the band, and leaves out those above it. Residues carry the points' numbers, taken from
/// `points` [points of the data set].
BandModes modes_in_band(std::vector<identify::Mode> modes, const std::vector<int>& points,
                        std::pair<double, double> band_Hz);

/// Classifies modes by the two sensors whose angles suit best, and by the overlay of their FRFs at each mode's peak.
std::vector<identify::ModeClassification> classify_modes(const std::vector<identify::Mode>& modes,
                                                         const identify::FrfDataset& set,
                                                         const std::vector<acquire::SignalInfo>& accel,
                                                         const identify::ClassifyOptions& options);

/// Fits `modes` to each hit's FRFs, starting from their frequencies. `dataset_of` gives the FRFs of one hit.
std::vector<HitMode> modes_of_hits(const std::vector<identify::Mode>& modes, const std::vector<std::size_t>& hits,
                                   const std::function<identify::FrfDataset(std::size_t hit)>& dataset_of,
                                   identify::Effort effort);

/// The stabilisation diagram of `set` with the poles within the band.
identify::Stabilisation stabilisation_in_band(const identify::FrfDataset& set, std::pair<double, double> band_Hz);

}  // namespace percuss::pipeline
