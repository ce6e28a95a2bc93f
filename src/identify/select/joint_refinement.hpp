#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/joint_fit.hpp"
#include "identify/model/frf_dataset.hpp"
#include "identify/select/sequential_fit.hpp"

namespace percuss::identify {

/// Fits all modes together. A mode takes its values from the joint fit where this fits the mode's window no worse than
/// the local fit does. It keeps the local fit where the model of the whole band fails: frequency scatter, a mode too
/// many or too few. Returns the residual of the joint fit, [channels][lines]. It is empty where that fit does not
/// converge, or where it is worse than the local fit for every mode.
std::vector<Eigen::VectorXcd> refine_jointly(const FrfDataset& set, std::vector<FittedMode>& modes);

/// Sets a mode's values to those of mode m of a joint fit.
void take_joint_mode(const FrfDataset& set, const JointFit& joint, std::size_t m, FittedMode& mode);

}  // namespace percuss::identify
