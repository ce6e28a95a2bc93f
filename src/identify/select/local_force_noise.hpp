#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Adds what the force's noise does to the poles to the deviations that a window's residual gave: a gain that wavers
/// with frequency is no noise from line to line, and moves all lines of a resonance together. Modes that the joint fit
/// gave have it already; of those that move from point to point the spread between the points tells.
/// theory (4.12)
void add_force_noise(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
