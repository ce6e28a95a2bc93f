#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "identify/fit/joint_fit.hpp"
#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// The better of two joint fits: one from the poles of `modes`, one also from the stable poles around which the
/// residual is large enough to disturb a mode. Modes that the residual of this fit shows, and close modes, are added.
/// Modes that only follow the misfit of others are removed. Where crowded_fit() finds a fit, this fit is returned
/// instead. Nothing where no fit settles, or with more than 150 starts. `residual` belongs to `modes`,
/// [channels][lines].
std::optional<JointFit> best_joint_fit(const FrfDataset& set, const std::vector<Eigen::VectorXcd>& residual,
                                       const std::vector<FittedMode>& modes);

}  // namespace percuss::identify
