#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

inline constexpr double kMaxFittedDamping = 0.5;
/// Whether all poles are within the limits of a fit: frequency above zero, damping ratio between 1e-7 and 0.5.
bool poles_in_bounds(const std::vector<Pole>& poles);

/// The poles after a step. shape  step [2 modes], in the order frequency (Hz), damping ratio per mode.
std::vector<Pole> updated_poles(std::vector<Pole> poles, const Eigen::VectorXd& step);

/// The largest normalised element of a step, in magnitude. The step of a frequency is divided by half the half-power
/// bandwidth, the step of a damping ratio by the damping ratio.
double normalised_step(const Eigen::VectorXd& step, const std::vector<Pole>& poles);

}  // namespace percuss::identify
