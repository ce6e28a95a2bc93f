#pragma once
#include <vector>

#include "identify/classify/type_posterior.hpp"

namespace percuss::identify {

/// Natural logarithm of the Bayes factor of a fault over a correct set-up. The fault multiplies the second sensor's
/// signal by `factor`: −1 where one of the sensors is reversed, 9.81 where the second one is in m/s² and the first in
/// g. With the fault, the true ratio of each mode is its measured ratio divided by `factor`. Both hypotheses are judged
/// over all modes, with bending, hoop and other types as alternatives for each mode, and with any direction of the blow
/// and of the tube's planes (log_set_up_evidence). A factor other than −1 stretches the angle χ of the ratio and so
/// changes its density. This change counts only against the fault, because real bats are not exact enough for a
/// coincidence in χ to be evidence.
/// theory (6.8)
double log_fault_evidence(const std::vector<TypeEvidence>& modes, const RatioLikelihood& likelihood, double factor);

/// The ratio divided by `factor`, as the angle χ of the quotient and its standard deviation.
RatioAngle divided_by(const RatioAngle& ratio, double factor);

}  // namespace percuss::identify
