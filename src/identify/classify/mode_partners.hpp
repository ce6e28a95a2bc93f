#pragma once
#include <vector>

#include "identify/classify/classify.hpp"
#include "identify/classify/type_posterior.hpp"

namespace percuss::identify {

/// Whether two frequencies may be one mode of a tube in its two planes: within options.double_peak_Hz or kPairSpacing
/// of the lower one.
bool near_enough_for_one_mode(double a_Hz, double b_Hz, const ClassifyOptions& options);

/// Sets TypeEvidence::partner of each two modes that are nearest to each other and near_enough_for_one_mode().
void find_partners(std::vector<TypeEvidence>& modes, const ClassifyOptions& options);

}  // namespace percuss::identify
