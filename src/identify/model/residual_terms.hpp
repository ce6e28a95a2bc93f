#pragma once
#include <Eigen/Core>

#include "frf/spectra.hpp"

namespace percuss::identify {

/// Residual terms: real accelerances that stand for the modes outside the spectral lines. They are the mass line,
/// undamped modes at fixed multiples of the highest frequency, and one mode below the lines. Their linear
/// combinations follow the tails of any modes outside. shape  [lines.count, terms].
/// theory (3.6)
Eigen::MatrixXd out_of_band_terms(const acquire::LineRange& lines);

}  // namespace percuss::identify
