#pragma once
#include <vector>

#include "identify/hits/mode_windows.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// Adds the misfit of the model to the modes' standard deviations. Noise differs from line to line; misfit is smooth.
/// Where the residual of a mode's window correlates between lines, the standard deviations follow from the Fisher
/// information and the residual's covariance (sandwich). A further term lets frequency and damping change along the
/// decay. If it clearly improves the fit, the standard deviations are at least the shift that it causes in the pole.
/// Where the points, or with few points the FRFs, scatter beyond the noise, the standard deviations are at least as
/// large as this scatter makes them. Modes with frequency scatter, the other modes of their windows, and all modes
/// under an exponential window stay unchanged. So do modes outside the spectral lines, whose contributions remain in
/// the windows. Modes ascend in frequency. theory (4.20), (4.34)
void add_misfit(const FrfDataset& set, std::vector<Mode>& modes);

/// Takes the standard deviations of the modes as the part of the noise, and adds the part of the misfit (add_misfit).
std::vector<Mode> with_misfit(const FrfDataset& set, std::vector<Mode> modes);

}  // namespace percuss::identify
