#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "identify/fit/variable_projection.hpp"

namespace percuss::identify {

/// Fewer points do not show a scatter.
inline constexpr std::size_t kMinScatterPoints = 3;

/// Standard deviations of the poles of a window, [2 modes] in Hz and damping ratio, from the contributions of the
/// points to the poles (cluster-robust). A misfit that differs from point to point makes them scatter beyond the noise,
/// whatever its shape along frequency. 0 where they scatter as noise makes them, and with fewer than kMinScatterPoints
/// points. The noise_scale of `projection` is the residuals' standard deviation per line. theory (4.20)
Eigen::VectorXd point_scatter_std(const VariableProjection& projection, const ProjectedState& state, std::size_t modes);

/// The same for the FRFs of few points: the two sensors on a tube, for example, see its two planes, whose frequencies
/// differ. The FRFs are not a sample of the structure, so the standard deviations cover what they show; 0 with one FRF.
/// The noise_scale of `projection` is the noise without misfit. The residuals' standard deviations do not show the
/// scatter: the fit that weights by them follows one FRF, and leaves its misfit to the others. theory (4.34)
Eigen::VectorXd sensor_scatter_std(const VariableProjection& projection, const ProjectedState& state,
                                   std::size_t modes);

}  // namespace percuss::identify
