#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "identify/local_fit.hpp"
#include "identify/mode.hpp"

namespace percuss {

struct QuickOptions {
  std::optional<std::size_t> modes;  // keep this many, the most significant ones
  std::vector<double> start_Hz;      // these and no others
};

/// Modes from peaks: prominent maxima of the summed FRFs, each fitted over a window of its own lines with what the
/// other modes contribute subtracted (a few sweeps), close ones together; a second mode is added where one leaves a
/// residual it explains. Deviations are scaled by each window's residual. Modes in ascending frequency.
std::vector<Mode> identify_quick(const FrfSet& set, const QuickOptions& options = {});

}  // namespace percuss
