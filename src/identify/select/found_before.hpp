#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/joint_fit.hpp"
#include "identify/select/fitted_mode.hpp"

namespace percuss::identify {

/// The residual of modes found before a joint search, [channels][lines]. `residual` is the residual of a joint fit of
/// these modes; if it is empty, it is computed. Around a mode with frequency scatter, the result is scaled down to the
/// rms residual of the mode's own window, where the mode has its own pole at each point.
std::vector<Eigen::VectorXcd> residual_before(const FrfDataset& set, const std::vector<FittedMode>& modes,
                                              std::vector<Eigen::VectorXcd> residual);

/// Number of real unknowns of these modes: poles and complex residues, and the own poles of a mode with frequency
/// scatter at each point.
std::size_t unknowns_of(const FrfDataset& set, const std::vector<FittedMode>& modes);

/// Modes of the joint fit that may only describe the frequency scatter of one mode: the modes near it, except the
/// strongest. A drift during the decay makes them fit somewhat better than one mode with a pole at each point.
/// Ascending.
std::vector<std::size_t> scatter_partners(const FrfDataset& set, const std::vector<FittedMode>& modes,
                                          const JointFit& fit);

}  // namespace percuss::identify
