#pragma once
#include <vector>

#include "identify/model/effort.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The frequencies of unmodelled peaks, largest first, and of stable poles that no mode describes. Near a mode there
/// are none: its misfit has stable poles, too.
std::vector<double> unmodelled_frequencies_Hz(const FrfDataset& set, const std::vector<Mode>& modes);

/// The modes at frequencies where `modes` have none, in ascending frequency. The lines around each are analysed alone,
/// as in a narrow band: few modes and residual terms describe what all modes of the band together do not. Such modes
/// may also describe tones: see whether their residues follow the force.
/// theory (4.21)
std::vector<Mode> modes_at_frequencies(const FrfDataset& set, const std::vector<Mode>& modes,
                                       const std::vector<double>& freq_Hz, Effort effort);

}  // namespace percuss::identify
