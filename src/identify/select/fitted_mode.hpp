#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

/// A mode as the fit of its own window of spectral lines gives it.
struct FittedMode {
  Mode mode;
  double peak_to_residual = 0;           // the mode's peak over the rms residual of the window's fit
  std::size_t first = 0, count = 0;      // the window, common to modes that were fitted together
  Eigen::VectorXd noise;                 // [channels] rms residual of the window's fit per line, (m/s²)/N
  std::size_t unknowns_per_channel = 0;  // real unknowns of the window's fit without its poles
  bool joint = false;                    // taken over from a fit of all modes together
};

/// The modes of all groups with their standard deviations, in ascending frequency. Where a frequency scatters between
/// the impact points, the values come from scattered_modes().
std::vector<FittedMode> fitted_modes(const WindowedFit& fit);

/// The modes' poles, in the same order.
std::vector<Pole> poles_of(const std::vector<FittedMode>& modes);

}  // namespace percuss::identify
