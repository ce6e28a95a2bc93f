#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Fits all modes together. Each mode takes over the joint fit where its window is fitted as well as by the local fit.
/// It keeps the local fit where the model of the whole band fails: frequency scatter, a mode too many or too few.
void refine_jointly(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
