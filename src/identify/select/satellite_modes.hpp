#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// Satellites are modes that are tiny beside a mode less than a bandwidth away. They may only correct what the fit of a
/// window lacks, the tails of the modes outside it; then the fit of all modes together does not converge. Removes the
/// satellites if the joint fit of the other modes is as good in every window as the local fits with satellites. Returns
/// the residual of that fit as refine_jointly does; empty where `modes` stay.
std::vector<Eigen::VectorXcd> refine_without_satellites(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
