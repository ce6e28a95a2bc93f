#pragma once
#include <Eigen/Core>

#include "identify/model/frf_dataset.hpp"

namespace percuss::identify {

/// Complex mode indicator function: the singular values of the FRF matrix [points × channels] at each spectral line,
/// largest first. A mode is a peak of the first value; two modes share a frequency where the second peaks as well. An
/// FRF that was not measured counts as zero. With one channel there is one value: √Σ|H|².
/// shapes  result [band.count, min(points, channels)]; `band` within set.lines.
/// units   (m/s²)/N.
/// theory (5.6)
Eigen::MatrixXd cmif(const FrfDataset& set, const acquire::LineRange& band);

}  // namespace percuss::identify
