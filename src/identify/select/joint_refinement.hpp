#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Fits all modes together and takes that over for each mode whose window it explains as well as the local fit did:
/// where the model of the whole band does not hold (a mode that moves, one too many or too few), the local fit stands.
void refine_jointly(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
