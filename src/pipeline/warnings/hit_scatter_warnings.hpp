#pragma once
#include <vector>

#include "identify/model/mode.hpp"
#include "pipeline/warnings/warning.hpp"

namespace percuss::pipeline {

/// nonlinear: frequencies or damping ratios that follow the force of the hits; drifting: frequencies that follow the
/// order of the hits; hits_differ: modes that differ from hit to hit beyond the noise, for neither reason;
/// model_misfit: residuals with structure.
std::vector<Warning> hit_scatter_warnings(const std::vector<identify::Mode>& modes);

}  // namespace percuss::pipeline
