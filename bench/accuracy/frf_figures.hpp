#pragma once
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "figures.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// The errors of H1, H2 and Hv, in this order, over the lines of the band, all channels and all runs, without times.
///   error       √(Σ|Ĥ − H|²/Σ|H|²)
///   over_bound  √(mean |Ĥ − H|²/σ²),  σ² = N σ_a²/Σ_hits|F|²                                             (1)
/// σ² is the bound of a single line with a known force. H is exact (synth/synthesise.hpp); N is the number of samples
/// of a row, σ_a the noise of the acceleration, F the spectrum of the force of a hit.
std::vector<Figure> frf_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth);

}  // namespace percuss::accuracy
