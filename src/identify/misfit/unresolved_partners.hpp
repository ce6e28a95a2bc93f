#pragma once
#include <vector>

#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// The misfit of one resonance can look like a second mode in its bandwidth. Such a partner is unresolved where the
/// misfit explains its damping: the standard deviation of the damping with misfit is above half of it. Fits the other
/// modes again without unresolved partners, until none is left; `found` as it is where none is.
std::vector<FittedMode> without_unresolved_partners(const FrfDataset& set, std::vector<FittedMode> found,
                                                    const SequentialFitOptions& options);

}  // namespace percuss::identify
