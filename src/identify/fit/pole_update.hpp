#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/model/modal_model.hpp"

namespace percuss::identify {

inline constexpr double kMaxFittedDamping = 0.5;
/// Poles a fit may try: frequency above zero, damping ratio between 1e-7 and a half.
bool poles_in_bounds(const std::vector<Pole>& poles);

/// The poles after a step, [2 modes] in the order frequency (Hz), damping ratio per mode.
std::vector<Pole> updated_poles(std::vector<Pole> poles, const Eigen::VectorXd& step);

/// The largest part of a step in the units that matter: half a half-power bandwidth for a frequency, itself for a
/// damping ratio.
double normalised_step(const Eigen::VectorXd& step, const std::vector<Pole>& poles);

}  // namespace percuss::identify
