#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "identify/fit/joint_projection.hpp"

namespace percuss::identify {

/// How strongly the lines contradict that a mode's residues are real: by a phase common to all channels, or by phases
/// that differ between them (score tests; the phase that the force's noise may cause is allowed for). Above 1 they do.
/// The mode is fitted with real residues; `covariance` is that of the poles.
double phase_test_statistic(const JointProjection& projection, const JointState& state, std::size_t mode,
                            const Eigen::MatrixXd& covariance);

}  // namespace percuss::identify
