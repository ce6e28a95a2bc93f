#pragma once
#include <vector>

#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// Fits the residues of all modes together, at their poles, where the residues from the modes' own windows do not add
/// up to the FRFs: where modes overlap, several windows describe the same motion. The modes then have one pole for all
/// points. Changes nothing if the residual of the sum is small, or not much larger than the common fit's residual.
void fit_common_residues(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
