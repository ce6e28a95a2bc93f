#pragma once
#include <optional>
#include <vector>

#include "identify/model/frf_dataset.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// The first or the last spectral line, in Hz, if the residual of the modes grows towards it, and if it is the end
/// nearer to misfit_Hz in octaves. Nothing otherwise. The residual grows if its energy over the noise is far larger at
/// this end than anywhere else, which is the effect of the tail of a mode beyond the lines. The tail cannot explain a
/// misfit near the other end: a suspended structure, for example, has such a residual above its suspension modes.
/// Modes outside the band must be among `modes`, because their resonances would be part of the residual.
/// modes      with their residues in the order of set.channels.
/// misfit_Hz  frequency of the mode whose misfit the end is to explain; above zero.
std::optional<double> growing_end_Hz(const FrfDataset& set, const std::vector<Mode>& modes, double misfit_Hz);

}  // namespace percuss::identify
