#pragma once
#include <vector>

#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// The misfit of one resonance can look like a second mode in its bandwidth. Of two close modes, the less clear one is
/// unresolved if the standard deviation of its damping ratio, misfit included, exceeds half of the damping ratio. Fits
/// the other modes again without the unresolved ones, until no mode is unresolved. Returns `found` unchanged if no mode
/// is unresolved.
std::vector<FittedMode> without_unresolved_partners(const FrfDataset& set, std::vector<FittedMode> found,
                                                    const SequentialFitOptions& options);

}  // namespace percuss::identify
