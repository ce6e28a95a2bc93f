#pragma once
#include <Eigen/Core>
#include <vector>

#include "identify/fit/variable_projection.hpp"
#include "identify/hits/mode_windows.hpp"

namespace percuss::identify {

/// The magnitude of the shift of a window's poles when each mode in turn gets one more term. shape [2 × modes]: the
/// frequency in Hz and the damping ratio of each mode.
/// The term describes a pole that changes during the decay: in proportion to the remaining amplitude (a second pole
/// with twice the decay), or in proportion to time (the second derivative of the mode by its frequency). The term's
/// coefficient is common to all FRFs. The largest shift of each unknown counts; 0 where no term improves the fit
/// clearly.
Eigen::VectorXd decay_term_shift(const FrfDataset& set, const ModeWindow& window, const std::vector<Pole>& poles,
                                 const VariableProjection& projection, const ProjectedState& state,
                                 const Eigen::VectorXd& noise);

}  // namespace percuss::identify
