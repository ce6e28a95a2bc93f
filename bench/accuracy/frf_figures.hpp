#pragma once
#include <string>
#include <utility>
#include <vector>

#include "acquire/record/record.hpp"
#include "figures.hpp"
#include "synth/synthesise.hpp"

namespace percuss::accuracy {

/// Errors of H1, H2 and Hv over the band's lines, all channels and all runs, in that order; times are left out.
///   error       √(Σ|Ĥ − H|²/Σ|H|²)
///   over_bound  √(mean |Ĥ − H|²/σ²),  σ² = N σ_a²/Σ_hits|F|²: of a line by itself, the force known       (1)
/// H is exact (synth/record.hpp).
std::vector<Figure> frf_errors(const std::vector<std::pair<int, acquire::Record>>& runs, const synth::Truth& truth);

}  // namespace percuss::accuracy
