#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A peak that shows and that no mode stands for.
struct UnmodelledPeak {
  double freq_Hz = 0;
  double level_dB = 0;  // of Σ|H|² over the channels, under its largest line
};

/// Prominent peaks (as identification starts from) further than three half-power bandwidths, and three lines, from
/// every mode, where the force reaches; those within `range_dB` of the largest line. Ascending.
std::vector<UnmodelledPeak> unmodelled_peaks(const FrfDataset& set, const std::vector<Mode>& modes, double range_dB);

}  // namespace percuss::identify
