#pragma once
#include <optional>
#include <vector>

#include "identify/model/mode.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// nonlinear: frequencies or damping ratios that follow the force of the hits; drifting: frequencies that follow the
/// order of the hits; hits_differ: modes that differ from hit to hit beyond the noise, for neither reason;
/// model_misfit: residuals with structure. `residual_end_Hz`: the end of the spectral lines towards which the residual
/// grows (identify::growing_end_Hz).
std::vector<Warning> hit_scatter_warnings(const std::vector<identify::Mode>& modes,
                                          std::optional<double> residual_end_Hz = std::nullopt);

/// Whether model_misfit names the mode: the misfit's part of its ± is more than five times the noise's part.
bool misfits_much(const identify::Mode& mode);

}  // namespace percuss::pipeline
