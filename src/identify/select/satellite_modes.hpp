#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// Satellites are tiny modes less than a bandwidth away from a much larger mode. Some of them are not modes: they stand
/// for the tails of modes outside the window, which a local fit lacks. With such satellites, the joint fit of all modes
/// does not converge. Removes the satellites if the joint fit of the other modes is as good in every window as the
/// local fits with satellites. Returns the residual of that fit as refine_jointly does; empty if `modes` do not change.
std::vector<Eigen::VectorXcd> refine_without_satellites(const FrfDataset& set, std::vector<FittedMode>& modes);

}  // namespace percuss::identify
