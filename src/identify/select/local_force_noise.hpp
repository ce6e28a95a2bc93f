#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Adds the effect of the force's noise to the standard deviations of poles from local fits. A local fit computes them
/// from its residual. The force's noise causes a gain error that varies smoothly over frequency, so the residual does
/// not show it. Modes from the joint fit stay unchanged, because this fit includes the effect. Modes with frequency
/// scatter also stay unchanged, because the scatter between the points includes it.
/// theory (4.12)
void add_force_noise(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
