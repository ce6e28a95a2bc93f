#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Adds the effect of the force's noise to the poles' standard deviations from a window's residual. The gain error
/// varies smoothly over frequency, so that the residual does not show it. Excluded are modes from the joint fit, which
/// includes the effect, and modes with frequency scatter, where the scatter between the points includes it.
/// theory (4.12)
void add_force_noise(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
