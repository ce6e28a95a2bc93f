#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "identify/fit/joint_projection.hpp"

namespace percuss::identify {

/// Score test of the hypothesis that a mode's residues are real, against a phase common to all FRFs and against phases
/// that differ between them. Above 1 the hypothesis is rejected. The phase error from the force's noise is allowed for.
/// The mode is fitted with real residues; `covariance` belongs to the poles.
double phase_test_statistic(const JointProjection& projection, const JointState& state, std::size_t mode,
                            const Eigen::MatrixXd& covariance);

}  // namespace percuss::identify
