#pragma once
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"
#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// The modes with the noise of the force in their standard deviations. Where the modes' residues do not add up to the
/// FRFs, fits all residues together (fit_common_residues).
std::vector<Mode> finished_modes(const FrfDataset& set, std::vector<FittedMode> found);

}  // namespace percuss::identify
