#pragma once
#include <vector>

#include "identify/frf_set.hpp"
#include "identify/peak_fit.hpp"

namespace percuss {

/// Fits all modes together and takes that over for each mode whose window it explains as well as the local fit did:
/// where the model of the whole band does not hold (a mode that moves, one too many or too few), the local fit stands.
void refine(const FrfSet& set, std::vector<PeakMode>& modes);

}  // namespace percuss
