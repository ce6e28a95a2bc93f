#pragma once
#include <vector>

#include "identify/classify/ratio_likelihood.hpp"

namespace percuss::identify {

/// Natural logarithm of the Bayes factor of a tube over an object of any shape, from the ratios of the modes' residues
/// at two sensors. On a tube, bending modes share a plane, and hoop modes share the placement error of the sensors. u
/// is the prior weight of a plane and a placement (Σ u = 1); the priors of the types are 1, 1 and 0.05:
///   L_tube = Σ_plane,placement u Π_modes (L_bending + L_hoop + L_other)/Σ priors,   L_any = Π_modes 1/π         (1)
/// 0 for no mode. theory (6.7)
double log_tube_evidence(const std::vector<RatioAngle>& ratios, const RatioLikelihood& likelihood);

}  // namespace percuss::identify
