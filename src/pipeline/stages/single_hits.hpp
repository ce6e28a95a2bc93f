#pragma once
#include <cstddef>
#include <map>
#include <vector>

#include "identify/hits/hit_frfs.hpp"
#include "pipeline/stages/frf_averages.hpp"

namespace percuss::pipeline {

/// The index of each point of the accepted hits in the set of their FRFs: ascending by number.
std::map<int, std::size_t> places_of_points(const TestSpectra& spectra);

/// Indices of the accepted hits that can be compared one by one. The spectrum of a double contact has zeros, near which
/// the FRF of this hit alone is poor: such hits are left out where two other hits remain.
std::vector<std::size_t> comparable_hits(const TestSpectra& spectra);

/// The FRFs of single hits. `set` is the average of the accepted hits. The result refers to the spectra.
identify::HitFrfs single_hits(const identify::FrfDataset& set, const TestSpectra& spectra,
                              const std::vector<std::size_t>& hits);

}  // namespace percuss::pipeline
