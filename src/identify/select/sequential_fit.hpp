#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/fit/windowed_fit.hpp"
#include "identify/model/effort.hpp"
#include "identify/model/mode.hpp"

namespace percuss::identify {

struct SequentialFitOptions {
  int rounds = 6;      // of looking for second modes in each window, then for modes that show no peak
  bool hidden = true;  // look for the latter
  WindowedFitOptions windows;
  std::optional<std::size_t> modes;  // keep this many, the most significant ones
  std::vector<double> start_Hz;      // these and no others
  std::vector<Pole> start;           // those of these, from an earlier fit, that are credible
};
/// What each effort spends on a peak; see effort.hpp for what that costs and gives.
SequentialFitOptions sequential_fit_options(Effort effort);

/// A mode as the fit of its own window of lines gives it.
struct FittedMode {
  Mode mode;
  double peak_to_residual = 0;          // its peak over what the window's fit leaves
  std::size_t first = 0, count = 0;     // the window, common to modes that were fitted together
  Eigen::VectorXd noise;                // [outputs] rms per line of what the window's fit leaves, (m/s²)/N
  std::size_t unknowns_per_output = 0;  // real unknowns of the window's fit, its poles aside
  bool joint = false;                   // taken over from a fit of all modes together
};

/// Modes from peaks: prominent maxima of the summed FRFs, each fitted over a window of its own lines with what the
/// other modes contribute subtracted (a few sweeps), close ones together. A second mode is added where one leaves a
/// residual it explains, and modes too weak to show are looked for in what is left. Deviations are scaled by
/// each window's residual. Modes in ascending frequency.
std::vector<FittedMode> fit_sequentially(const FrfDataset& set, const SequentialFitOptions& options = {});

}  // namespace percuss::identify
