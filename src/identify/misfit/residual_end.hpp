#pragma once
#include <optional>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The first or the last spectral line, in Hz, if the residual of the modes grows towards it: its energy over the noise
/// is far larger at this end than anywhere else. The tail of a mode beyond the lines has this effect. Nothing
/// otherwise. Modes outside the band must be among `modes`, because their resonances would be part of the residual.
/// modes  with their residues in the order of set.channels.
std::optional<double> growing_end_Hz(const FrfDataset& set, const std::vector<Mode>& modes);

}  // namespace percuss::identify
