#pragma once
#include <Eigen/Core>
#include <vector>

namespace percuss::identify {

/// True where a residual, [channels][lines], is smooth over some block of spectral lines once its linear trend is
/// subtracted. Noise is not smooth. A quick test before a search for resonances.
bool smooth_somewhere(const std::vector<Eigen::VectorXcd>& residual);

}  // namespace percuss::identify
