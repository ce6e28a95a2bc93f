#pragma once
#include <Eigen/Core>

#include "frf/spectra.hpp"

namespace percuss::identify {

/// What lies beyond the lines, as real accelerances: the mass line, undamped guard modes at fixed places above the
/// lines and one below them. Combinations of these follow the tails of any modes out there. shape  [lines.count,
/// terms].
/// theory (3.6)
Eigen::MatrixXd out_of_band_terms(const frf::LineRange& lines);

}  // namespace percuss::identify
