#pragma once
#include <vector>

#include "identify/hits/mode_windows.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// Adds the misfit of the model to the modes' standard deviations. Noise differs from line to line; misfit is smooth.
/// Where the residual of a mode's window correlates between lines, the standard deviations follow from the Fisher
/// information and the residual's covariance (sandwich). They are at least the shift of the pole when one more term,
/// for a frequency and damping that change along the decay, improves the fit clearly. Modes with frequency scatter, and
/// all modes under an exponential window, stay unchanged. Modes ascend in frequency.
/// theory (4.20)
void add_misfit(const FrfDataset& set, std::vector<Mode>& modes);

}  // namespace percuss::identify
