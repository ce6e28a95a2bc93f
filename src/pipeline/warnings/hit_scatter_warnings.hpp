#pragma once
#include <optional>
#include <vector>

#include "identify/model/mode.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// nonlinear: frequencies or damping ratios that follow the force of the hits; drifting: frequencies that follow the
/// order of the hits; hits_differ: modes that differ from hit to hit beyond the noise, for neither reason;
/// model_misfit: residuals with structure. `residual_end_Hz`: the end of the spectral lines towards which the residual
/// grows and which explains the largest misfit (identify::growing_end_Hz). `force_known`: false for FRFs that were
/// given: the noise of their force may be the cause.
std::vector<Warning> hit_scatter_warnings(const std::vector<identify::Mode>& modes,
                                          std::optional<double> residual_end_Hz = std::nullopt,
                                          bool force_known = true);

/// The misfit's part of the mode's ± over the noise's part, where this exceeds five, so that model_misfit names the
/// mode; otherwise 0.
double much_misfit(const identify::Mode& mode);

}  // namespace percuss::pipeline
